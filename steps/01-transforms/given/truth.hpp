// The ground truth of step 01's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes without its approximations: the hall has an exact cylinder as wall, whatever "hall.segments" is,
/// and the triangle has a camera that shows clip space. The shading is that of preview.glsl. Throws Error for an
/// unknown scene, and for an output or a camera that the triangle does not have.
SceneTruth transform_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
