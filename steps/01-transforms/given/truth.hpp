// What step 01's pictures ought to be: nothing here calls a function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes without its approximations: the hall has a truly round wall however many pieces "hall.segments"
/// asks for, and the triangle stands before a camera that shows clip space. Shading as preview.glsl has it. Throws
/// Error for an unknown scene, and for an output or a camera that the triangle does not have.
SceneTruth transform_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
