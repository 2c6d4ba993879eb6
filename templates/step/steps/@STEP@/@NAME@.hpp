// @STEP@: the contract. You write @NAME@.cpp (runs once, on the CPU) and @NAME@.glsl (runs for every pixel); a GLSL
// function's contract is the comment above it.
//
// Homogeneous fog absorbs the fraction 1 - exp(-density distance) of the light, and adds the same fraction of its own
// colour. (Bouguer 1729; Lambert 1760; for fog: Akenine-Moller et al., "Real-Time Rendering".)
#pragma once

#include <stdexcept>

namespace atelier::@NAME@ {

/// The density, 1/m, of fog that lets half of the light through after `half_distance` metres: ln 2 / half_distance.
/// A distance below 1e-6 m counts as 1e-6 m; infinity gives 0. Throws std::invalid_argument if the distance is not
/// above 0, NaN included.
float density(float half_distance);

}  // namespace atelier::@NAME@
