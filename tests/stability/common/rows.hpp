// The table of what the steps stand on: colours, comparison, shapes, exact world matrices.
#pragma once

#include "stability/rows.hpp"

namespace atelier::stability {

void add_colour_rows(Table& table);
void add_compare_rows(Table& table);
void add_shape_rows(Table& table);
void add_scene_rows(Table& table);

}  // namespace atelier::stability
