// The ground truth of step 12's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The gallery with a round wall, shadow rays in place of cubes, and rooms behind paintings: traced through portals, or
/// traced first as the pictures, normals and heights that the paintings show. Previews have the size that the settings
/// ask for, and are filtered linearly. Styles are those of steps 09 and 10. Throws Error for "walk.seconds" above 0.
SceneTruth gallery_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
