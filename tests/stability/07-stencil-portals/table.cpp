// Step 07's table of extremes.
#include "stability/07-stencil-portals/rows.hpp"
#include "stability/entry.hpp"

// begin_mark and begin_restore only tell OpenGL what to do: cases read the stencil, depth and colour buffers back.
void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_portal_rows(table);
  add_mirror_rows(table);
  add_view_rows(table);
  add_plane_rows(table);
  add_rectangle_rows(table);
  add_through_rows(table);
  add_carried_rows(table);
  add_plane_in_view_rows(table);
  add_oblique_rows(table);
  add_cut_rows(table, shaders);
  add_crossing_rows(table);
  add_oblique_order_rows(table);
  add_image_rows(table);
  add_body_rows(table);
  add_light_rows(table, shaders);
}
