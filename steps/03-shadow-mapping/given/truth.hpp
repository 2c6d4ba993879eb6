// The ground truth of step 03's pictures. Nothing here calls a student's function. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The shadows of the light that "light.width" asks for.
void use_shadows(oracle::Shading& shading, const Settings& settings);

/// The same for a program with the maps of this step and without the cubes of step 04: point lights cast no shadows.
void use_shadows_without_cubes(SceneTruth& truth, const Settings& settings);

/// The step's scenes with shadow rays instead of maps: hard shadows if "light.width" is 0, otherwise soft shadows,
/// integrated over 32 x 32 points of each light. Settings of maps, biases and filters are ignored.
/// - "shadow_factor" is the fraction of the light "shadow.light" that each point sees: 1 if the scene has no such
///   light, it casts no shadows, or no caster is in its reach.
/// - "shadow_coordinate" and "shadow_map" are the truth of the map's own formulas, not of the shadows: the coordinate
///   of each point, and the casters as the light sees them, for the settings "shadow.fit" and front-face culling. A map
///   is traced at the centres of the picture's pixels, which are the texels' centres if the picture has the map's size.
///   Everything is zero for a light without a map, and so are coordinates on surfaces that receive no shadow.
/// Throws Error for an unknown scene; for coordinates and maps if "shadow.fit" is "visible" (which depends on the
/// renderer) or "fixed"; for a map that is not square; and for maps and coordinates of a point light.
SceneTruth shadow_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

}  // namespace atelier
