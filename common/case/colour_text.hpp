// Colours as text: on the command line, in case files and in lists.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace atelier {

/// Linear red, green and blue with the primaries of sRGB; 1 is the brightest that a screen shows. In double precision,
/// so that the limits of a range compare exactly and text reads back unchanged.
using Colour = glm::dvec3;

/// Reads "0.2,0.5,1", three finite linear values without spaces, or "#3380ff", 8-bit sRGB codes, which it converts to
/// linear values (IEC 61966-2-1). Nothing for any other text.
std::optional<Colour> parse_colour(std::string_view text);

/// "0.2,0.5,1": the shortest text from which parse_colour reads the same colour.
std::string colour_text(const Colour& colour);

}  // namespace atelier
