// @STEP@: the contract. You write @NAME@.cpp (what happens once, on the CPU) and @NAME@.glsl (what happens for
// every pixel); the GLSL function's contract stands above it.
//
// Air that is the same everywhere takes the share 1 - exp(-density way) of the light on its way, and adds as large a
// share of its own colour. (Bouguer 1729; Lambert 1760; as a fog: Akenine-Moller et al., "Real-Time Rendering".)
#pragma once

#include <stdexcept>

namespace atelier::@NAME@ {

/// The density, 1/m, of air that lets half of the light through after `half_distance` metres: ln 2 / half_distance.
/// A distance below 1e-6 m counts as 1e-6 m; infinity gives 0. Throws std::invalid_argument where the distance is not
/// above 0, NaN included.
float density(float half_distance);

}  // namespace atelier::@NAME@
