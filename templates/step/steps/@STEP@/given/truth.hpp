// What step @NUMBER@'s pictures ought to be: nothing here calls a function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes, lit as step 02's truth has them, through exact air: "@NAME@.pieces" only trades accuracy for
/// speed, and is passed over. Throws Error for an unknown scene.
SceneTruth @NAME@_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
