#include "03-shadow-mapping/given/truth.hpp"

#include <fmt/format.h>

#include "02-blinn-phong/given/truth.hpp"
#include "03-shadow-mapping/given/map_truth.hpp"
#include "03-shadow-mapping/given/scenes.hpp"
#include "base/error.hpp"
#include "oracle/shadow.hpp"
#include "scene/builder.hpp"

namespace atelier {

namespace {

constexpr int points_a_side = 32;  ///< of a light: the error at shadow edges is at most 1/64 (oracle/shadow.hpp)

/// Shows numbers instead of light, on a black background.
void show(SceneTruth& truth, oracle::SurfaceColour numbers) {
  truth.shading.surface = std::move(numbers);
  truth.output = "colour";
  set_background(truth.scene, glm::vec3(0));
}

/// The light of the shadow outputs; null if the scene has fewer lights.
const Light* shown_light(const Scene& scene, const Settings& settings) {
  const auto index = std::size_t(settings.integer("shadow.light"));
  return index < scene.lights.size() ? &scene.lights[index] : nullptr;
}

/// A light without casters in its reach has the factor 1.
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
    // Depths in front of the near plane are clamped to it.
    return glm::dvec3(std::max(exact_shadow_coordinate(frustum, point.position).z, 0.0));
  };
}

void show_map_or_coordinate(SceneTruth& truth, const TruthRequest& request, const Settings& settings) {
  const std::string& fit = settings.choice("shadow.fit");
  if (fit == "visible" || fit == "fixed")
    throw Error(fmt::format(
        "output '{}' has no ground truth for shadow.fit={}, which depends on more than the scene; use scene or casters",
        request.output, fit));
  const bool map = request.output == "shadow_map";
  if (map && request.size.x != request.size.y)
    throw Error(fmt::format("output 'shadow_map' of {}x{} pixels has no ground truth: a map is square", request.size.x,
                            request.size.y));
  const Light* light = shown_light(truth.scene, settings);
  if (light && light->type == LightType::point)
    throw Error(
        fmt::format("output '{}' has no ground truth for '{}', a point light: one map cannot cover all directions",
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

void use_shadows(oracle::Shading& shading, const Settings& settings) {
  shading.light_width = settings.real("light.width");
  shading.light_samples = points_a_side;
  shading.shadows = shading.light_width > 0 ? oracle::Shadows::soft : oracle::Shadows::hard;
}

void use_shadows_without_cubes(SceneTruth& truth, const Settings& settings) {
  use_shadows(truth.shading, settings);
  for (Light& light : truth.scene.lights)
    if (light.type == LightType::point) light.casts_shadow = false;
}

SceneTruth shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(shadow_scenes(), request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  use_shadows(truth.shading, settings);
  if (request.output == "shadow_factor") show_factor(truth, shown_light(truth.scene, settings));
  if (request.output == "shadow_coordinate" || request.output == "shadow_map")
    show_map_or_coordinate(truth, request, settings);
  return truth;
}

}  // namespace atelier
