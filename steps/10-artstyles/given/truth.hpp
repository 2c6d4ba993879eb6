// The ground truth of step 10's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The truth of step 08's chain, then the styles in double precision. A fish-eye of the scene itself is traced: each
/// pixel's ray goes where the lens looks. It takes its colours from the picture, linearly filtered, where something is
/// in the way: another style or bloom before it, an overlay, a lens that is undone afterwards, or an orthographic
/// camera. Strokes are painted by slow versions of the student's functions. Edges of cubes' faces and threads are
/// ignored.
SceneTruth style_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

/// The styles of the settings on the truth of any picture before them; the request's output is "colour" or one of this
/// step.
SceneTruth in_styles(SceneTruth truth, const TruthRequest& request, const Settings& settings);

}  // namespace atelier
