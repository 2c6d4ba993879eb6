// The ground truth of step 09's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes, shaded and with the passes of step 08, then dithered in double precision. Errors are diffused
/// exactly where a picture has exact codes (scene `card`); elsewhere a last digit of the light changes pixels in its
/// neighbourhood. Throws Error for blue noise, whose pattern is the student's own.
SceneTruth dither_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

/// The truth of any picture, dithered as the settings say.
SceneTruth in_few_levels(SceneTruth truth, const TruthRequest& request, const Settings& settings);

}  // namespace atelier
