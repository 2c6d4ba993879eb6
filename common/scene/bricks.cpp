// A brick wall as matching textures of colour, height and normals, for normal and parallax mapping.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/error.hpp"
#include "scene/noise.hpp"
#include "scene/textures.hpp"

namespace atelier {
namespace {

void check(const BrickShape& shape) {
  const auto require = [](const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high))
      throw Error(fmt::format("bricks: {} {} (allowed: {}..{})", name, value, low, high));
  };
  require("size", shape.size, 1, 8192);
  require("columns", shape.columns, 1, 64);
  require("rows", shape.rows, 2, 64);
  require("joint", shape.joint, 0, 0.4);
  require("depth", shape.depth, 0, 0.2);
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

double ramp(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

struct Sample {
  glm::dvec3 colour;
  double height;  ///< 0..1
};

Sample sample(const BrickShape& shape, double u, double v) {
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

/// Tangent-space normals of a tileable height map; `depth` is the height of 1, in texture sides.
Image normals_of(const Image& height, double depth) {
  const int n = height.width();
  Image normals(n, n);
  const auto h = [&](int x, int y) { return double(height.at((x + n) % n, (y + n) % n).r) * depth; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const double slope_u = (h(x + 1, y) - h(x - 1, y)) * n / 2;
      const double slope_v = (h(x, y - 1) - h(x, y + 1)) * n / 2;  // v runs up, rows run down
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope_u, -slope_v, 1)) * 0.5 + 0.5;
      normals.at(x, y) = {float(normal.x), float(normal.y), float(normal.z), 1};
    }
  return normals;
}

}  // namespace

BrickTextures make_bricks(const BrickShape& shape) {
  check(shape);
  const int n = shape.size;
  BrickTextures bricks{Image(n, n), Image(n, n), {}};
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const Sample s = sample(shape, (x + 0.5) / n, 1 - (y + 0.5) / n);
      bricks.colour.at(x, y) = {float(s.colour.r), float(s.colour.g), float(s.colour.b), 1};
      const float height = float(s.height);
      bricks.height.at(x, y) = {height, height, height, 1};
    }
  bricks.normal = normals_of(bricks.height, shape.depth);
  return bricks;
}

}  // namespace atelier
