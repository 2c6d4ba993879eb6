// The ground truth of step 02's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes with per-pixel lighting (for any "shading"), exact powers ("specular.power") and texels that are
/// decoded before they are filtered ("texture.decode"). Settings that define the picture are used: lights and blinds,
/// normalisation, materials, and nearest or linear filtering; mipmaps are not, since they approximate supersampling.
/// Textures are stored as 8-bit sRGB. Throws Error for an unknown scene.
SceneTruth blinn_phong_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
