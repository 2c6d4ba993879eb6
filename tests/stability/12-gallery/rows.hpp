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

}  // namespace atelier::stability
