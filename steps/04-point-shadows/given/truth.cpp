#include "04-point-shadows/given/truth.hpp"

#include <algorithm>

#include "03-shadow-mapping/given/map_truth.hpp"
#include "03-shadow-mapping/given/truth.hpp"
#include "04-point-shadows/given/scenes.hpp"
#include "base/error.hpp"
#include "oracle/shadow.hpp"
#include "scene/builder.hpp"

namespace atelier {

namespace {

/// The point light of the shadow outputs.
const Light* shown_point_light(const Scene& scene, const Settings& settings) {
  const auto index = std::size_t(settings.integer("shadow.light"));
  if (index >= scene.lights.size() || scene.lights[index].type != LightType::point) return nullptr;
  return &scene.lights[index];
}

/// The distance that a light's cube stores as 1: 1.001 times that of the farthest corner of a caster's box. 0 without
/// casters.
double farthest_distance(const Scene& scene, const glm::dvec3& light) {
  double farthest = 0;
  for (const glm::dvec3& corner : caster_corners_exact(scene))
    farthest = std::max(farthest, glm::distance(corner, light));
  return 1.001 * farthest;
}

/// What a pixel shows instead of light.
oracle::SurfaceColour numbers_for(const TruthRequest& request, const Settings& settings, const Light& light,
                                  const SceneTruth& truth) {
  if (request.output == "shadow_factor")
    return [light, shading = truth.shading](const oracle::World& world, const oracle::SurfacePoint& point,
                                            const glm::dvec3&) {
      return glm::dvec3(oracle::visibility(world, point, light, shading));
    };
  if (request.output == "shadow_map")
    throw Error("output 'shadow_map' of a point light has no ground truth: no camera shows six faces in one picture");
  if (settings.choice("cube.instead") != "never")
    throw Error(
        "output 'shadow_coordinate' of a point light has no ground truth for cube.instead=cone, which depends on your "
        "cone_around; use cube.instead=never");
  const double far = farthest_distance(truth.scene, light.position);
  return [far, light](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3&) {
    return far > 0 && point.receives_shadow ? (point.position - light.position) / far : glm::dvec3(0);
  };
}

}  // namespace

SceneTruth point_shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(point_scenes(), request.scene, settings);
  if (!request.output.starts_with("shadow_")) return shadow_truth(request, settings, std::move(model));
  TruthRequest lit = request;
  lit.output = "colour";
  SceneTruth truth = shadow_truth(lit, settings, model);  // of the active lights: light.count may disable some
  const Light* light = shown_point_light(truth.scene, settings);
  if (!light) return shadow_truth(request, settings, std::move(model));
  truth.shading.surface = numbers_for(request, settings, Light(*light), truth);
  set_background(truth.scene, glm::vec3(0));  // the background has no value
  truth.output = "colour";
  return truth;
}

}  // namespace atelier
