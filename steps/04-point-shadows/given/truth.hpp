// What step 04's pictures ought to be: nothing here calls a function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes with shadow rays instead of maps: as shadow_truth of step 03.
SceneTruth point_shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
