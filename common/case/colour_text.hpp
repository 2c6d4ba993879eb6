// A colour in words: how a command line, a case file and a list write one.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace atelier {

/// Red, green and blue in linear light, with the primaries of sRGB; 1 is the brightest that a screen shows. In double
/// precision, so that a range's own ends are in it and text reads back the same.
using Colour = glm::dvec3;

/// Reads "0.2,0.5,1", three finite numbers of linear light without spaces, or "#3380ff", 8-bit sRGB codes that are
/// decoded to linear light (IEC 61966-2-1). Nothing for any other text.
std::optional<Colour> parse_colour(std::string_view text);

/// "0.2,0.5,1": the shortest text that parse_colour reads back as the same colour.
std::string colour_text(const Colour& colour);

}  // namespace atelier
