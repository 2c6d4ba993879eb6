// What step 03's pictures ought to be: nothing here calls a function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes with shadow rays instead of maps: hard shadows where "light.width" is 0, otherwise shadows of
/// lights with that extent, integrated over 32 x 32 points of each. Settings of maps, biases and filters are passed
/// over.
/// - "shadow_factor" is the fraction of the light "shadow.light" that each point sees: 1 where the scene has no such
///   light, it casts no shadows, or nothing that does is within its reach.
/// - "shadow_coordinate" and "shadow_map" show how far the light's map is from its own formulas, not from the truth
///   about shadows: the coordinate of each point, and the casters as the light sees them, "shadow.fit" (and culling of
///   front faces) being followed. A map is traced at the middles of the picture's pixels, which are those of the texels
///   where the picture is as large as the map. All is zero for a light without a map, and so are coordinates on what
///   receives no shadow.
/// Throws Error for an unknown scene; for coordinates and maps where "shadow.fit" is "visible" (what the renderer finds
/// in its own view) or "fixed" (none at all); for a map that is not square; and for maps and coordinates of a point
/// light, which one map does not go round.
SceneTruth shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
