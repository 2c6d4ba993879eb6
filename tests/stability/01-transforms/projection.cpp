// perspective, perspective_reversed, orthographic: from the narrowest to the widest that makes sense, and refusals.
#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using transforms::orthographic;
using transforms::perspective;
using transforms::perspective_reversed;

namespace {

constexpr float degree = std::numbers::pi_v<float> / 180;
constexpr float quarter_turn = 90 * degree;

using Project = glm::mat4(float fov_y, float aspect, float near, float far);

/// A point of view space after the division, by a matrix taken as it is: only its own entries are in error.
glm::dvec3 projected(const glm::mat4& projection, const glm::dvec3& point) {
  const glm::dvec4 clip = glm::dmat4(projection) * glm::dvec4(point, 1);
  return glm::dvec3(clip) / clip.w;
}

/// Where the upper right corner of the picture comes to lie, which is (1, 1); relative.
double corner_error(Project* project, float fov_y, float aspect) {
  const double top = std::tan(double(fov_y) / 2);
  const glm::dvec3 at = projected(project(fov_y, aspect, 1, 2), {top * double(aspect), top, -1});
  return difference({at.x, at.y}, {1, 1});
}

double depth_error(float near, float far, double z) {
  return std::abs(projected(perspective(1, 1, near, far), {0, 0, -z}).z - exact::depth(near, far, z));
}
double reversed_depth_error(float near, float far, double z) {
  const double expected = exact::depth_reversed(near, far, z);
  const double actual = projected(perspective_reversed(1, 1, near, far), {0, 0, -z}).z;
  return expected == 0 ? std::abs(actual) * z / double(near) : std::abs(actual - expected) / expected;
}

/// What both kinds of perspective refuse.
void add_refusals(Group& group, Project* project, bool infinite_far) {
  struct Case {
    const char* words;
    float fov_y, aspect, near, far;
  };
  const Case cases[] = {
      {"an angle of 0", 0, 1, 1, 2},
      {"a negative angle", -1, 1, 1, 2},
      {"an angle of 179.01 degrees", 179.01f * degree, 1, 1, 2},
      {"an angle of 180 degrees, whose tangent is negative in floats", 180 * degree, 1, 1, 2},
      {"an infinite angle", infinite, 1, 1, 2},
      {"an angle of NaN", not_a_number, 1, 1, 2},
      {"an aspect of 0", 1, 0, 1, 2},
      {"a negative aspect", 1, -1, 1, 2},
      {"an aspect of NaN", 1, not_a_number, 1, 2},
      {"near 0", 1, 1, 0, 2},
      {"near negative", 1, 1, -1, 2},
      {"near NaN", 1, 1, not_a_number, 2},
      {"near = far", 1, 1, 2, 2},
      {"near behind far", 1, 1, 3, 2},
      {"far NaN", 1, 1, 1, not_a_number},
      {"near and far infinite", 1, 1, infinite, infinite},
  };
  for (const Case& c : cases) group.refuses(c.words, [=] { project(c.fov_y, c.aspect, c.near, c.far); });
  if (infinite_far) group.finite("an infinite far plane", [=] { return values(project(1, 1, 0.1f, infinite)); });
}

/// Angles and aspects, the same for both kinds.
void add_angle_rows(Group& group, Project* project) {
  const Bound bound{6 * rounding_unit, "relative", "tangent, reciprocal and quotient, and the angle's half"};
  for (const float degrees : {1e-10f, 1e-3f, 45.0f, 90.0f, 170.0f, 178.0f})
    group.close(fmt::format("an angle of {:g} degrees", degrees), bound,
                [=] { return corner_error(project, degrees * degree, 1); });
  group.close("an angle of 179 degrees",
              {3 * rounding_unit + 2 * rounding_unit / std::cos(179 * degree / 2), "relative",
               "cot x = tan(pi/2 - x): an ulp of the half angle is a rounding over the cosine, here 1/115"},
              [=] { return corner_error(project, 179 * degree, 1); });
  for (const float aspect : {1e-6f, 1.0f / 16384, 16384.0f, 1e6f})
    group.close(fmt::format("an aspect of {:g}", aspect), bound,
                [=] { return corner_error(project, quarter_turn, aspect); });
}

void add_perspective_rows(Table& table) {
  Group group = table.of("perspective");
  add_refusals(group, perspective, false);
  add_angle_rows(group, perspective);
  struct Range {
    const char* words;
    float near, far;
  };
  const Range ranges[] = {
      {"far/near 1e9", 1e-3f, 1e6f}, {"near 1e-20 m, far 1e18 m", 1e-20f, 1e18f}, {"near 1 m, far 1e38 m", 1, 1e38f}};
  const Bound absolute{4 * rounding_unit, "absolute",
                       "two entries of a quotient each; their sum is taken exactly here"};
  for (const Range& r : ranges)
    for (const bool at_far : {false, true})
      group.close(fmt::format("{}: the depth of the {} plane", r.words, at_far ? "far" : "near"), absolute,
                  [=] { return depth_error(r.near, r.far, at_far ? r.far : r.near); });
  group.close("planes a hundred-thousandth apart",
              {4 * rounding_unit * 2e5, "absolute",
               "depth is a difference of two numbers of (far + near)/(far - near) = 2e5, each known to two roundings"},
              [] { return depth_error(1, 1.00001f, 1.000005); });
  group.close("2000 random cameras: near and far to -1 and +1",
              {24 * rounding_unit, "absolute",
               "two entries of at most 2 roundings each, with (far + near)/(far - near) up to 3 at far/near = 2"},
              [] {
                return worst_of(2000, 30, [](Trial& t) {
                  const float near = float(t.size_between(1e-4, 1e3)), far = near * float(t.size_between(2, 1e9));
                  return std::max(depth_error(near, far, near), depth_error(near, far, far));
                });
              });
}

void add_reversed_rows(Table& table) {
  Group group = table.of("perspective_reversed");
  add_refusals(group, perspective_reversed, true);
  add_angle_rows(group, perspective_reversed);
  const Bound relative{6 * rounding_unit, "relative",
                       "depth is one entry over the distance, a ratio and a difference away from its inputs"};
  for (const float far : {1e6f, 1e9f, 1e30f, infinite})
    for (const double distance : {0.001, 1.0, 1e6})
      if (distance < far / 2)
        group.close(fmt::format("near 1 mm, far {:g} m: depth {:g} m away", far, distance), relative,
                    [=] { return reversed_depth_error(1e-3f, far, distance); });
  group.close("near 1 mm, far 1e6 m: the far plane",
              {4 * rounding_unit, "of near / far", "two entries cancel there; what remains is a share of either"},
              [] { return reversed_depth_error(1e-3f, 1e6f, double(1e6f)); });
}

/// The corners of the box against those of the cube.
double box_error(float left, float right, float bottom, float top, float near, float far) {
  const glm::mat4 m = orthographic(left, right, bottom, top, near, far);
  return std::max(difference(values(projected(m, {left, bottom, -double(near)})), {-1, -1, -1}),
                  difference(values(projected(m, {right, top, -double(far)})), {1, 1, 1}));
}

void add_orthographic_rows(Table& table) {
  Group group = table.of("orthographic");
  const Bound bound{6 * rounding_unit, "absolute", "a sum, a difference and a quotient in each of two entries"};
  group.refuses("left = right", [] { orthographic(1, 1, 0, 1, 0, 1); });
  group.refuses("bottom = top", [] { orthographic(0, 1, -2, -2, 0, 1); });
  group.refuses("near = far", [] { orthographic(0, 1, 0, 1, 5, 5); });
  group.refuses("near = far = 0", [] { orthographic(0, 1, 0, 1, 0, 0); });
  group.close("a box turned round in all directions", bound, [] { return box_error(3, -1, 2, -2, 9, 4); });
  group.close("near behind the camera", bound, [] { return box_error(-1, 1, -1, 1, -100, 100); });
  group.close("a box 1e-30 m wide", bound, [] { return box_error(-1e-30f, 1e-30f, 0, 1e-30f, 1e-30f, 3e-30f); });
  group.close("a box 1e30 m wide", bound, [] { return box_error(-1e30f, 1e30f, 0, 1e30f, 1e30f, 3e30f); });
  group.close(
      "a metre, a million metres away",
      {4 * rounding_unit * 2e6, "absolute",
       "the offset entry is (right + left)/(right - left) = 2e6, known to two roundings, as is the scaled corner"},
      [] { return box_error(1e6f, 1e6f + 1, 1e6f, 1e6f + 1, 1e6f, 1e6f + 1); });
  group.nan("a side of NaN", [] { return values(orthographic(not_a_number, 1, 0, 1, 0, 1)); });
}

}  // namespace

void add_projection_rows(Table& table) {
  add_perspective_rows(table);
  add_reversed_rows(table);
  add_orthographic_rows(table);
}

}  // namespace atelier::stability
