// Tables of colours that the program offers. Given.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace atelier {

/// "identity", "warm", "night".
std::vector<std::string> look_names();

/// The colour that a look makes of a colour; both sRGB-encoded, 0..1.
glm::dvec3 look_of(const std::string& name, const glm::dvec3& encoded);

/// A look as the text of a .cube file, with `size` grid points along each axis.
std::string look_text(const std::string& name, int size);

}  // namespace atelier
