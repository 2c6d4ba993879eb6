// The table of step 01, a function for each part of its contract.
#pragma once

#include "01-transforms/transforms.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_matrix_rows(Table& table);
void add_hierarchy_rows(Table& table);
void add_view_rows(Table& table);
void add_projection_rows(Table& table);
void add_normal_rows(Table& table, ShaderFunctions& shaders);
void add_mesh_rows(Table& table);
void add_buffer_rows(Table& table, ShaderFunctions& shaders);
void add_window_rows(Table& table);
void add_world_offset_rows(Table& table, ShaderFunctions& shaders);
void add_depth_order_rows(Table& table, ShaderFunctions& shaders);

}  // namespace atelier::stability
