// The ground truth of step @NUMBER@'s pictures. Calls no function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes, lit as in step 02's truth, with exact fog: "@NAME@.pieces" only trades accuracy for speed, and is
/// ignored. Throws Error for an unknown scene.
SceneTruth @NAME@_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
