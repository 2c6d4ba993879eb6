// Hue, chroma and luma in double precision, by other ways than the solution's: what the rows of step 08 are held
// against. A hue is a place on the way round the six corners of the colour cube, and the gamut is searched by halving.
#pragma once

#include <glm/glm.hpp>

#include "stability/random.hpp"

namespace atelier::stability {

using Colour = glm::dvec3;

double luma_of(const Colour& c);
double chroma_of(const Colour& c);  ///< NaN where a component is
/// In turns, 0 <= hue < 1; 0 for a grey.
double hue_of(const Colour& c);

/// How far one hue is from another, the shorter way round: 0 to 0.5 turns.
double turns_between(double a, double b);

/// The colour of this hue and luma with as much of the chroma as fits into 0..1.
Colour colour_with(double hue, double chroma, double luma);

/// The largest absolute component; NaN where one is.
double largest_of(const Colour& c);

/// Each component evenly spread over 0..1.
glm::vec3 some_colour(Trial& t);
/// Each component evenly spread in the logarithm.
glm::vec3 some_light(Trial& t, double low, double high);

}  // namespace atelier::stability
