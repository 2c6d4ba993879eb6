// The table of extremes of common/.
#include "stability/common/rows.hpp"
#include "stability/entry.hpp"

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions&) {
  using namespace atelier::stability;
  add_colour_rows(table);
  add_compare_rows(table);
  add_shape_rows(table);
  add_scene_rows(table);
}
