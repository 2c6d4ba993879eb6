// The ground truth of step 05's pictures. Calls no function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes, lit as in step 02's truth, under their normal maps, with tangents and lighting in double
/// precision. Ignored: "normal.tangents", "normal.space", "normal.format" and "specular.filtered", which only trade
/// accuracy for speed. Throws Error for an unknown scene.
SceneTruth normal_mapping_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
