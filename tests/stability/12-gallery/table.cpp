// Step 12's table of extremes.
#include "stability/12-gallery/rows.hpp"
#include "stability/entry.hpp"

// make_preview and record only tell OpenGL what to do: cases read the textures and their mipmaps back.
void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions&) {
  using namespace atelier::stability;
  add_wall_rows(table);
  add_painting_rows(table);
  add_meets_rows(table);
  add_side_rows(table);
  add_touches_rows(table);
  add_through_rows(table);
  add_moved_rows(table);
  add_held_rows(table);
  add_camera_rows(table);
  add_schedule_rows(table);
  add_style_rows(table);
}
