#include "04-point-shadows/truth.hpp"

#include "03-shadow-mapping/truth.hpp"
#include "04-point-shadows/scenes.hpp"

namespace atelier {

SceneTruth point_shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_point_scene(request.scene, settings);
  return shadow_truth(request, settings, std::move(model));
}

}  // namespace atelier
