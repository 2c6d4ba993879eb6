// The table of step 01, a function for each part of its contract.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "01-transforms/transforms.hpp"
#include "stability/random.hpp"
#include "stability/shader_function.hpp"
#include "stability/table.hpp"

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

inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();
inline constexpr float largest_float = std::numeric_limits<float>::max();
inline constexpr float denormal = 1e-40f;

/// How far m is from keeping lengths and angles: R^T R from the identity, det R from 1, for its upper left 3x3.
inline double not_rigid(const glm::mat4& m) {
  const glm::dmat3 r(m);
  return std::max(difference(values(glm::transpose(r) * r), values(glm::dmat3(1))), std::abs(glm::determinant(r) - 1));
}

}  // namespace atelier::stability
