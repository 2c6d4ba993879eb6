// Scenes for measurements: each isolates one property of a cube shadow map. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// The settings of the scene `dots`.
std::vector<SettingSpec> study_settings();

/// Balls around a point light cast round shadows onto a plate. The camera is at the light and does not see the balls,
/// which are in front of its near plane. So the picture shows directions, 24 degrees high and wide, and the shadow
/// edges have the same length and distance for any view direction. `study.angle` rotates all of it away from the centre
/// of the face -z, towards an edge of the cube (45 degrees away) or a corner (54.7), by `study.towards`. Plate and
/// balls rotate with the camera, the cube does not.
Scene dots(const Settings& settings);

/// A point light among six walls that are rotated against its cube and do not touch: incidence angles are 0 to 83
/// degrees, and there are no shadows.
Scene bare_walls();

/// The same with thin boards on the floor and on the walls; light leaks through them if the bias is larger than their
/// thickness.
Scene boards();

}  // namespace atelier
