// The shaders of the wall.
#pragma once

#include <string>

namespace atelier::relief_demo {

std::string wall_vertex();

/// Writes `output`: colour, normal or texcoord. With `parallax` u_depths is followed.
std::string wall_fragment(bool parallax, const std::string& output);

}  // namespace atelier::relief_demo
