#include "03-shadow-mapping/given/truth.hpp"

#include <fmt/format.h>

#include "02-blinn-phong/given/truth.hpp"
#include "03-shadow-mapping/given/map_truth.hpp"
#include "03-shadow-mapping/given/scenes.hpp"
#include "base/error.hpp"
#include "oracle/shadow.hpp"

namespace atelier {

namespace {

constexpr int points_a_side = 32;  ///< of a light: edges of shadows are off by at most 1/64 (oracle/shadow.hpp)

/// A picture of numbers instead of light, black where nothing is seen.
void show(SceneTruth& truth, oracle::SurfaceColour numbers) {
  truth.shading.surface = std::move(numbers);
  truth.output = "colour";
  truth.scene.background = glm::vec3(0);
}

/// Which light the outputs are about; none: the scene has fewer.
const Light* shown_light(const Scene& scene, const Settings& settings) {
  const auto index = std::size_t(settings.integer("shadow.light"));
  return index < scene.lights.size() ? &scene.lights[index] : nullptr;
}

/// A light without a caster in its reach darkens nothing that it could light.
void show_factor(SceneTruth& truth, const Light* light) {
  if (!light || (light->type != LightType::point && !exact_frustum(truth.scene, *light, MapFit::scene)))
    return show(truth, [](const auto&...) { return glm::dvec3(1); });
  const oracle::Shading plain = truth.shading;
  show(truth,
       [light = *light, plain](const oracle::World& world, const oracle::SurfacePoint& point, const glm::dvec3&) {
         return glm::dvec3(oracle::visibility(world, point, light, plain));
       });
}

void show_coordinate(SceneTruth& truth, const ExactFrustum& frustum) {
  show(truth, [frustum](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3&) {
    return point.receives_shadow ? exact_shadow_coordinate(frustum, point.position) : glm::dvec3(0);
  });
}

void show_map(SceneTruth& truth, const ExactFrustum& frustum, bool back_faces_only) {
  truth.scene = casters_alone(std::move(truth.scene), back_faces_only);
  truth.camera = camera_of(frustum);
  truth.output = "colour";
  truth.shading.surface = [frustum](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3&) {
    // What stands before the near plane is pressed onto it.
    return glm::dvec3(std::max(exact_shadow_coordinate(frustum, point.position).z, 0.0));
  };
}

void show_map_or_coordinate(SceneTruth& truth, const TruthRequest& request, const Settings& settings) {
  const std::string& fit = settings.choice("shadow.fit");
  if (fit == "visible" || fit == "fixed")
    throw Error(
        fmt::format("output '{}' has no ground truth under shadow.fit={}, which does not follow from the scene; scene "
                    "and casters have one",
                    request.output, fit));
  const bool map = request.output == "shadow_map";
  if (map && request.size.x != request.size.y)
    throw Error(fmt::format("output 'shadow_map' of {}x{} pixels has no ground truth: a map is as wide as it is high",
                            request.size.x, request.size.y));
  const Light* light = shown_light(truth.scene, settings);
  if (light && light->type == LightType::point)
    throw Error(fmt::format("output '{}' has no ground truth for '{}', a point light: one map does not go round it",
                            request.output, light->name));
  std::optional<ExactFrustum> frustum;
  if (light) frustum = exact_frustum(truth.scene, *light, fit == "scene" ? MapFit::scene : MapFit::casters);
  if (!frustum) return show(truth, [](const auto&...) { return glm::dvec3(0); });
  if (map)
    show_map(truth, *frustum, settings.choice("shadow.bias") == "front-faces");
  else
    show_coordinate(truth, *frustum);
}

}  // namespace

SceneTruth shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(shadow_scenes(), request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  truth.shading.light_width = settings.real("light.width");
  truth.shading.light_samples = points_a_side;
  truth.shading.shadows = truth.shading.light_width > 0 ? oracle::Shadows::soft : oracle::Shadows::hard;
  if (request.output == "shadow_factor") show_factor(truth, shown_light(truth.scene, settings));
  if (request.output == "shadow_coordinate" || request.output == "shadow_map")
    show_map_or_coordinate(truth, request, settings);
  return truth;
}

}  // namespace atelier
