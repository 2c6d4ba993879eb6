#include "@STEP@/given/truth.hpp"

#include <cmath>

#include "02-blinn-phong/given/truth.hpp"
#include "@STEP@/given/feature.hpp"
#include "@STEP@/given/scenes.hpp"
#include "oracle/shade.hpp"
#include "scene/builder.hpp"

namespace atelier {

SceneTruth @NAME@_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(@NAME@_scenes(), request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  const double half_distance = settings.real("@NAME@.half_distance");
  if (half_distance == 0 || request.output != "colour") return truth;
  set_background(truth.scene, @NAME@_air);
  truth.shading.surface = [half_distance, lit = truth.shading](
                              const oracle::World& world, const oracle::SurfacePoint& point, const glm::dvec3& eye) {
    const double through = std::exp2(-glm::distance(eye, point.position) / half_distance);
    return glm::mix(glm::dvec3(@NAME@_air), oracle::shade(world, point, eye, lit), through);
  };
  return truth;
}

}  // namespace atelier
