// A brick wall.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/error.hpp"
#include "scene/noise.hpp"
#include "scene/relief.hpp"
#include "scene/texture_detail.hpp"

namespace atelier {

using texture_detail::ramp;
using texture_detail::require;

namespace {

void check(const BrickShape& shape) {
  require("bricks", "columns", shape.columns, 1, 64);
  require("bricks", "rows", shape.rows, 2, 64);
  require("bricks", "joint", shape.joint, 0, 0.4);
  require("bricks", "depth", shape.depth, 0, 0.2);
  if (shape.rows % 2 != 0) throw Error(fmt::format("bricks: rows {} (allowed: even numbers, 2..64)", shape.rows));
}

/// A point's position in the bond.
struct Place {
  std::int64_t column, row;  ///< of the brick
  double edge;               ///< distance from the brick's border, in heights of a brick; negative in the mortar
};

Place place_in_bond(const BrickShape& shape, double u, double v) {
  const double y = v * shape.rows;
  const auto row = std::int64_t(y);
  const double x =
      u * shape.columns + (row % 2 == 0 ? 0.0 : 0.5);        // running bond: odd rows are shifted by half a brick
  const double aspect = double(shape.rows) / shape.columns;  // a brick's width over its height
  const double in_x = x - std::floor(x), in_y = y - double(row);
  const double edge = std::min(std::min(in_x, 1 - in_x) * aspect, std::min(in_y, 1 - in_y)) - shape.joint / 2;
  return {std::int64_t(std::floor(x)) % shape.columns, row, edge};
}

ReliefPoint point_at(const BrickShape& shape, double u, double v) {
  const Place place = place_in_bond(shape, u, v);
  const double rough = fractal_noise(shape.seed + 1, {32 * u, 32 * v}, {32, 32}, 3);
  const double brick = ramp(0, 0.09, place.edge);  // 0 in the joint, 1 on the brick's face, rounded in between
  const double raised = hash01(shape.seed + 2, place.column, place.row);
  const double height = glm::mix(0.12 * rough, 0.72 + 0.16 * raised + 0.12 * rough, brick);

  const double tone = hash01(shape.seed + 3, place.column, place.row);
  const glm::dvec3 clay = glm::mix(glm::dvec3(0.30, 0.075, 0.04), glm::dvec3(0.46, 0.16, 0.08), tone);
  const glm::dvec3 mortar(0.42, 0.4, 0.36);
  return {(0.7 + 0.5 * rough) * glm::mix(mortar, clay, brick), height};
}

}  // namespace

Relief make_bricks(const BrickShape& shape) {
  check(shape);
  return make_relief(shape.size, shape.depth, [&](double u, double v) { return point_at(shape, u, v); });
}

}  // namespace atelier
