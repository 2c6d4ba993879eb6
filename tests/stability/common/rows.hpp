// The table of what the steps stand on: colours, comparison, shapes, exact world matrices.
#pragma once

#include <limits>

#include "stability/random.hpp"
#include "stability/table.hpp"

namespace atelier::stability {

void add_colour_rows(Table& table);
void add_compare_rows(Table& table);
void add_shape_rows(Table& table);
void add_scene_rows(Table& table);

inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();
inline constexpr float largest_float = std::numeric_limits<float>::max();
inline constexpr float denormal = 1e-40f;

}  // namespace atelier::stability
