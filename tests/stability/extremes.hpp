// Floats and whole numbers at the ends of their ranges, and what is no number.
#pragma once

#include <limits>

namespace atelier::stability {

inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();
inline constexpr float largest_float = std::numeric_limits<float>::max();
inline constexpr float denormal = 1e-40f;  ///< below the smallest number that has all its digits, 1.2e-38

inline constexpr int least_int = std::numeric_limits<int>::min();
inline constexpr int largest_int = std::numeric_limits<int>::max();

}  // namespace atelier::stability
