// The table of step 12, a function for each part of its contract.
#pragma once

#include <cstdint>
#include <limits>

#include "12-gallery/gallery.hpp"
#include "stability/12-gallery/frames.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_wall_rows(Table& table);
void add_painting_rows(Table& table);
void add_meets_rows(Table& table);
void add_side_rows(Table& table);
void add_touches_rows(Table& table);
void add_through_rows(Table& table);
void add_moved_rows(Table& table);
void add_held_rows(Table& table);
void add_camera_rows(Table& table);
void add_schedule_rows(Table& table);
void add_style_rows(Table& table);

inline constexpr double double_unit = 0x1p-53;  ///< what one rounding of a double may cost, relative to the result
inline constexpr double million = 1e6;

/// A few roundings of coordinates of this size, in metres.
Bound metres(double size, const char* reason);

}  // namespace atelier::stability
