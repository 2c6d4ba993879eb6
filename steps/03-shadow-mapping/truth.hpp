// What step 03's pictures ought to be: nothing here calls a function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes with shadow rays instead of maps: hard shadows where "light.width" is 0, otherwise shadows of
/// lights with that extent, integrated over 32 x 32 points of each. All settings of maps, biases and filters are passed
/// over. "shadow_map" and "shadow_coordinate" are a matter of the technique and have no truth: Error. Throws Error for
/// an unknown scene.
SceneTruth shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
