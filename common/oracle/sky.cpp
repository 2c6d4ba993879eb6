#include "oracle/sky.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace atelier::oracle {

namespace {

/// The axes of a face: a direction d is on the face whose major axis has the largest d . major, at s = d . right and
/// t = d . down over that number, each -1..1 (OpenGL 3.3 core specification, table 3.19).
struct CubeFace {
  glm::dvec3 major, right, down;
};
constexpr std::array<CubeFace, 6> cube_faces = {{
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
}};

/// A point of a face in texels: (0.5, 0.5) is the centre of column 0 in row 0.
struct CubePoint {
  std::size_t face;
  glm::dvec2 at;
};

CubePoint cube_point(const glm::dvec3& direction, int edge) {
  std::size_t face = 0;
  for (std::size_t i = 1; i < cube_faces.size(); ++i)
    if (glm::dot(direction, cube_faces[i].major) > glm::dot(direction, cube_faces[face].major)) face = i;
  const CubeFace& axes = cube_faces[face];
  const glm::dvec2 st =
      glm::dvec2(glm::dot(direction, axes.right), glm::dot(direction, axes.down)) / glm::dot(direction, axes.major);
  return {face, (st + 1.0) * (0.5 * edge)};
}

/// The texel of a column and row, each -1..edge. Beyond an edge of the face it is the one of the adjoining face in the
/// direction of its centre; beyond a corner there is none.
std::optional<glm::dvec3> cube_texel(const Sky& sky, std::size_t face, int column, int row) {
  const int edge = sky.faces[0].width();
  const bool beside = column < 0 || column >= edge, above_or_below = row < 0 || row >= edge;
  if (beside && above_or_below) return std::nullopt;
  if (beside || above_or_below) {
    const CubeFace& axes = cube_faces[face];
    const double s = (2 * column + 1.0) / edge - 1, t = (2 * row + 1.0) / edge - 1;
    const CubePoint beyond = cube_point(axes.major + s * axes.right + t * axes.down, edge);
    return cube_texel(sky, beyond.face, int(beyond.at.x), int(beyond.at.y));
  }
  const Rgba& texel = sky.faces[face].at(column, row);
  return glm::dvec3(texel.r, texel.g, texel.b);
}

}  // namespace

glm::dvec3 sky_colour(const Sky& sky, const glm::dvec3& direction) {
  const CubePoint point = cube_point(direction, sky.faces[0].width());
  const glm::dvec2 first = glm::floor(point.at - 0.5), share = point.at - 0.5 - first;
  const int column = int(first.x), row = int(first.y);
  const std::array<std::optional<glm::dvec3>, 4> texels = {
      cube_texel(sky, point.face, column, row), cube_texel(sky, point.face, column + 1, row),
      cube_texel(sky, point.face, column, row + 1), cube_texel(sky, point.face, column + 1, row + 1)};
  glm::dvec3 sum(0);
  for (const auto& texel : texels) sum += texel.value_or(glm::dvec3(0));
  const auto at = [&](std::size_t i) { return texels[i].value_or(sum / 3.0); };
  return glm::mix(glm::mix(at(0), at(1), share.x), glm::mix(at(2), at(3), share.x), share.y);
}

}  // namespace atelier::oracle
