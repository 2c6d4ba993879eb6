// What step 02's pictures ought to be: nothing here calls a function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes, lit for every point (whatever "shading" says), with exact powers ("specular.power") and texels
/// that are decoded before they are mixed ("texture.decode"). Settings that say what is to be shown are followed:
/// lights and the blinds before them, normalisation, materials, and nearest or linear filtering; mipmaps have no
/// meaning here, since supersampling is what they approximate. Textures hold what an 8-bit sRGB file would. Throws
/// Error for an unknown scene.
SceneTruth blinn_phong_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
