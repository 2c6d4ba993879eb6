// Floats at the ends of their range, and what is none.
#pragma once

#include <limits>

namespace atelier::stability {

inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();
inline constexpr float largest_float = std::numeric_limits<float>::max();
inline constexpr float denormal = 1e-40f;  ///< below the smallest number that has all its digits, 1.2e-38

}  // namespace atelier::stability
