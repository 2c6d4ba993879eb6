// The ground truth of step 08's pictures, in double precision. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The traced scene, then every pass that the settings ask for, up to the requested output. The formats of targets,
/// fused passes and dithering are ignored.
SceneTruth post_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

/// 0.2126 r + 0.7152 g + 0.0722 b.
double luma_of(const glm::dvec3& c);

}  // namespace atelier
