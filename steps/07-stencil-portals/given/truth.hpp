// The ground truth of step 07's pictures. Calls no function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes as in step 05's truth, with rays that go through portals and are reflected by mirrors, as many as
/// "portals.depth" says; the camera has gone "visitor.way" by the rules of visitor.hpp. Ignored: how views are clipped,
/// bounded and left out, which changes speed and precision only. Throws Error for an unknown scene.
SceneTruth portal_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
