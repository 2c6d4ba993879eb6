#include "04-point-shadows/given/truth.hpp"

#include <algorithm>

#include "03-shadow-mapping/given/map_truth.hpp"
#include "03-shadow-mapping/given/truth.hpp"
#include "04-point-shadows/given/scenes.hpp"
#include "base/error.hpp"
#include "oracle/shadow.hpp"

namespace atelier {

namespace {

/// The point light that the outputs are about.
const Light* shown_lamp(const Scene& scene, const Settings& settings) {
  const auto index = std::size_t(settings.integer("shadow.light"));
  if (index >= scene.lights.size() || scene.lights[index].type != LightType::point) return nullptr;
  return &scene.lights[index];
}

/// The distance that a light's cube stores as 1: 1.001 times that of the farthest corner of a caster's box. 0 where
/// nothing casts.
double farthest_distance(const Scene& scene, const glm::dvec3& lamp) {
  double farthest = 0;
  for (const glm::dvec3& corner : caster_corners_exact(scene))
    farthest = std::max(farthest, glm::distance(corner, lamp));
  return 1.001 * farthest;
}

/// What a pixel shows instead of light.
oracle::SurfaceColour numbers_for(const TruthRequest& request, const Settings& settings, const Light& lamp,
                                  const SceneTruth& truth) {
  if (request.output == "shadow_factor")
    return [lamp, shading = truth.shading](const oracle::World& world, const oracle::SurfacePoint& point,
                                           const glm::dvec3&) {
      return glm::dvec3(oracle::visibility(world, point, lamp, shading));
    };
  if (request.output == "shadow_map")
    throw Error(
        "output 'shadow_map' of a point light has no ground truth: six pictures in one are no picture of a camera");
  if (settings.choice("cube.instead") != "never")
    throw Error(
        "output 'shadow_coordinate' of a point light has no ground truth under cube.instead=cone: whether one map "
        "serves is "
        "for your cone_around to say; cube.instead=never has one");
  const double far = farthest_distance(truth.scene, lamp.position);
  return [far, lamp](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3&) {
    return far > 0 && point.receives_shadow ? (point.position - lamp.position) / far : glm::dvec3(0);
  };
}

}  // namespace

SceneTruth point_shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(point_scenes(), request.scene, settings);
  if (!request.output.starts_with("shadow_")) return shadow_truth(request, settings, std::move(model));
  TruthRequest lit = request;
  lit.output = "colour";
  SceneTruth truth = shadow_truth(lit, settings, model);  // of the lights that shine: light.count may leave some out
  const Light* lamp = shown_lamp(truth.scene, settings);
  if (!lamp) return shadow_truth(request, settings, std::move(model));
  truth.shading.surface = numbers_for(request, settings, Light(*lamp), truth);
  truth.scene.background = glm::vec3(0);  // no number where nothing is seen
  truth.output = "colour";
  return truth;
}

}  // namespace atelier
