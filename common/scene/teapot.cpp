// Newell's teapot: bicubic Bezier patches turned into triangles.
//
// The control points are Martin Newell's of 1975, in the common form with the height scaled by Blinn and the bottom
// added by Crow (F. Crow, "The origins of the teapot", IEEE CG&A 7(1), 1987; also S. Baker's "teaset" files and the
// GLUT library). They are published as 306 points and 32 lists of 16, with much repetition: body, rim, lid and bottom
// are surfaces of revolution in four quarters, and handle and spout are mirrored halves. This file stores each part
// once. z is up in the data, y in our scenes.
#include <algorithm>
#include <array>

#include "scene/shape_detail.hpp"
#include "scene/shapes.hpp"

namespace atelier {

using namespace shape_detail;

namespace {

/// Rows run along v, columns along u.
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;

/// One circle of control points of a surface of revolution: a quarter of it is the Bezier curve (radius, 0),
/// (radius, handle), (handle, radius), (0, radius). A true circle has handle = 0.5523 radius; Newell used 0.56.
struct Ring {
  double radius, handle, height;
};
using Profile = std::array<Ring, 4>;  ///< from top to bottom, or for the lid from the middle outwards

constexpr Profile rim{{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}};
constexpr Profile body_upper{{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2, 1.12, 1.35}, {2, 1.12, 0.9}}};
constexpr Profile body_lower{{{2, 1.12, 0.9}, {2, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}};
constexpr Profile knob{{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}};
constexpr Profile lid{{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}};
constexpr Profile bottom{{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0}, {0, 0, 0}}};

constexpr double data_height = 3.15;  // from the table to the top of the knob

/// The halves at y <= 0. A row runs from the middle of one face of the handle over its side to the middle of the other
/// face.
constexpr Patch handle_upper{{{{{-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}}},
                              {{{-2.3, 0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}}},
                              {{{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3, -0.3, 2.25}, {-3, 0, 2.25}}},
                              {{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}}}}};
constexpr Patch handle_lower{{{{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}}},
                              {{{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3, -0.3, 1.35}, {-3, 0, 1.35}}},
                              {{{-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0, 0.9375}}},
                              {{{-2, 0, 0.9}, {-2, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}}}}};
constexpr Patch spout_lower{{{{{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}}},
                             {{{2.6, 0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0, 0.825}}},
                             {{{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}}},
                             {{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}}}};
constexpr Patch spout_upper{{{{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}},
                             {{{2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375}}},
                             {{{2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125}}},
                             {{{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}}}}};

/// The quarter of a profile that starts at `quarter` quarter turns from +x. u runs counter-clockwise from above, v
/// along the profile: the outside is where u runs to the right and v runs *down*.
Patch revolve(const Profile& profile, int quarter) {
  const glm::dvec2 right = circle_point(quarter, 4), ahead = circle_point(quarter + 1, 4);
  Patch patch;
  for (int row = 0; row < 4; ++row) {
    const auto& [radius, handle, height] = profile[row];
    const glm::dvec2 curve[4] = {{radius, 0}, {radius, handle}, {handle, radius}, {0, radius}};
    for (int i = 0; i < 4; ++i) patch[row][i] = glm::dvec3(curve[i].x * right + curve[i].y * ahead, height);
  }
  return patch;
}

/// The half at y >= 0: u runs counter-clockwise around the tube, as it does around a revolved surface.
Patch mirror(const Patch& patch) {
  Patch mirrored = patch;
  for (auto& row : mirrored)
    for (glm::dvec3& point : row) point.y = -point.y;
  return mirrored;
}

/// The same surface with u reversed: the half in the data runs clockwise and would be inside out.
Patch walk_back(const Patch& patch) {
  Patch reversed = patch;
  for (auto& row : reversed) std::reverse(row.begin(), row.end());
  return reversed;
}

/// Cubic Bernstein polynomials and their derivatives at t.
struct Basis {
  std::array<double, 4> value, slope;
};

Basis bernstein(double t) {
  const double s = 1 - t;
  return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
          {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t}};
}

glm::dvec3 evaluate(const Patch& patch, const std::array<double, 4>& along_u, const std::array<double, 4>& along_v) {
  glm::dvec3 sum(0);
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 4; ++i) sum += along_v[row] * along_u[i] * patch[row][i];
  return sum;
}

struct SurfacePoint {
  glm::dvec3 position, normal;  ///< the normal is unit length
};

/// The point at (u, v) and the normal dP/dv x dP/du. At the poles of lid and bottom a whole row of control points
/// coincides and dP/du is 0; it is replaced by d2P/dudv, which is parallel to dP/du near the pole.
SurfacePoint surface(const Patch& patch, double u, double v) {
  const Basis bu = bernstein(u), bv = bernstein(v);
  glm::dvec3 du = evaluate(patch, bu.slope, bv.value);
  const glm::dvec3 dv = evaluate(patch, bu.value, bv.slope);
  if (glm::dot(du, du) < 1e-20) {
    const double towards_inside = v < 0.5 ? 1 : -1;
    du = towards_inside * evaluate(patch, bu.slope, bv.slope);
  }
  return {evaluate(patch, bu.value, bv.value), glm::normalize(glm::cross(dv, du))};
}

/// A rectangle of the texture: the patch's u runs from left to right, its v from top to bottom.
struct TextureRect {
  double left, right, top, bottom;
};

void add_patch(Mesh& mesh, const Patch& patch, const TextureRect& rect, const TeapotShape& shape) {
  const int n = shape.subdivisions;
  const double scale = double(shape.height) / data_height;
  add_grid(mesh, n, n, [&](int column, int row) {
    const double u = double(column) / n, v = double(n - row) / n;  // rows of a grid run up, v runs down
    const SurfacePoint point = surface(patch, u, v);
    const auto y_up = [](const glm::dvec3& p) { return glm::vec3(p.x, p.z, -p.y); };
    return Vertex{y_up(scale * point.position), glm::normalize(y_up(point.normal)),
                  glm::vec2(glm::mix(rect.left, rect.right, u), glm::mix(rect.top, rect.bottom, v))};
  });
}

/// Four quarters, once around the texture.
void add_revolved(Mesh& mesh, const Profile& profile, double top, double bottom_v, const TeapotShape& shape) {
  for (int q = 0; q < 4; ++q) add_patch(mesh, revolve(profile, q), {q / 4.0, (q + 1) / 4.0, top, bottom_v}, shape);
}

/// Both halves of a tube, once around the texture. If the texture's v increases along the patch, u is reversed so that
/// the texture is not mirrored.
void add_mirrored(Mesh& mesh, const Patch& half, double top, double bottom_v, const TeapotShape& shape) {
  const bool rising = top < bottom_v;
  const double start = rising ? 1 : 0, end = rising ? 0 : 1;
  add_patch(mesh, mirror(half), {start, 0.5, top, bottom_v}, shape);
  add_patch(mesh, walk_back(half), {0.5, end, top, bottom_v}, shape);
}

}  // namespace

Mesh make_teapot(const TeapotShape& shape) {
  require_length("teapot", "height", shape.height);
  require_count("teapot", "subdivisions", shape.subdivisions, 2, 64);
  Mesh mesh{.name = "teapot"};
  add_revolved(mesh, rim, 1, 0.9, shape);
  add_revolved(mesh, body_upper, 0.9, 0.45, shape);
  add_revolved(mesh, body_lower, 0.45, 0, shape);
  add_revolved(mesh, knob, 1, 0.5, shape);
  add_revolved(mesh, lid, 0.5, 0, shape);
  add_revolved(mesh, bottom, 1, 0, shape);
  add_mirrored(mesh, handle_upper, 1, 0.5, shape);
  add_mirrored(mesh, handle_lower, 0.5, 0, shape);
  add_mirrored(mesh, spout_lower, 0, 0.5, shape);
  add_mirrored(mesh, spout_upper, 0.5, 1, shape);
  return mesh;
}

}  // namespace atelier
