// Step 01's table of extremes.
#include "stability/01-transforms/rows.hpp"
#include "stability/entry.hpp"

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_matrix_rows(table);
  add_hierarchy_rows(table);
  add_view_rows(table);
  add_projection_rows(table);
  add_normal_rows(table, shaders);
  add_mesh_rows(table);
  add_buffer_rows(table, shaders);
  add_window_rows(table);
  add_world_offset_rows(table, shaders);
  add_depth_order_rows(table, shaders);
}
