// The ground truth of step 04's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes with shadow rays instead of maps, like shadow_truth of step 03.
SceneTruth point_shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
