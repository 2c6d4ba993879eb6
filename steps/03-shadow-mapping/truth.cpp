#include "03-shadow-mapping/truth.hpp"

#include "02-blinn-phong/truth.hpp"
#include "03-shadow-mapping/scenes.hpp"

namespace atelier {

SceneTruth shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_shadow_scene(request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  truth.shading.shadows = oracle::Shadows::hard;
  return truth;
}

}  // namespace atelier
