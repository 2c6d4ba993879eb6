// The scenes of step 06. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& parallax_scenes();

/// The name of the nodes whose mesh is one rectangle (make_plane) under a relief: the truth replaces them by the relief
/// itself. Their mesh's texture coordinates run from (0, 0).
inline constexpr const char* relief_node = "relief";

/// The same for a mesh of make_cylinder_wall that is seen from outside, whose texture is as long around as up.
inline constexpr const char* round_relief_node = "round relief";

}  // namespace atelier
