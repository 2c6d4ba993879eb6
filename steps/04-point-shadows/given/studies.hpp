// Scenes made to be measured rather than looked at: each shows one property of a cube of distances, and as little else
// as can be. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// The settings of the scene `dots`.
std::vector<SettingSpec> study_settings();

/// Balls around a lamp throw round shadows onto a plate, and the camera stands in the lamp itself, looking past the
/// balls (they are before its near plane): the picture shows directions, 24 degrees up and across, and the shadows'
/// edges are as long and as far away wherever it points. `study.angle` turns all of it away from the middle of the face
/// -z, `study.towards` an edge of the cube (45 degrees away) or a corner (54.7). Plate and balls turn with the camera,
/// the cube does not.
Scene dots(const Settings& settings);

/// A lamp among six walls that stand askew to its cube and do not meet: light meets them at all angles to 83 degrees,
/// and there is not one shadow on them.
Scene bare_walls();

/// The same with thin boards on the floor and on the walls, which light passes through where a bias is wider than they
/// are.
Scene boards();

}  // namespace atelier
