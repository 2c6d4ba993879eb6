// oblique_projection: planes from a tenth of a millimetre to a kilometre away, up to 89 degrees off the view.
#include <optional>

#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

struct Frustum {
  double slope_x = 1, slope_y = 1, near = 0.1, far = 100;  ///< slopes: half the width at 1 m
  /// Rounded to floats, as step 01's is.
  glm::mat4 projection() const {
    glm::mat4 p(0);
    p[0][0] = float(1 / slope_x), p[1][1] = float(1 / slope_y);
    p[2][2] = float((near + far) / (near - far)), p[2][3] = -1, p[3][2] = float(2 * near * far / (near - far));
    return p;
  }
};

/// Tilted by so many degrees away from the view's direction, so far from the eye.
glm::vec4 tilted_plane(Trial& t, double distance, double degrees) {
  const double tilt = degrees * std::numbers::pi / 180, around = t.between(0, 2 * std::numbers::pi);
  return glm::vec4(
      glm::dvec4(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), -std::cos(tilt), -distance));
}

/// z and w of a point of view space.
glm::dvec2 depth_and_w(const glm::mat4& projection, const glm::dvec3& p) {
  const glm::dvec4 clip = glm::dmat4(projection) * glm::dvec4(p, 1);
  return {clip.z, clip.w};
}

/// A point of the plane in a direction of the frustum; none if that does not meet it before the eye, or at a cosine
/// below `least`.
std::optional<glm::dvec3> on_plane(Trial& t, const Frustum& frustum, const glm::vec4& plane, double least = 1e-3) {
  const glm::dvec3 along(frustum.slope_x * t.between(-1, 1), frustum.slope_y * t.between(-1, 1), -1);
  const double towards = glm::dot(glm::dvec3(plane), along);
  if (towards < least) return {};
  return along * (-double(plane.w) / towards);
}

/// The largest error over planes at this distance and tilt: z = -w on the plane.
double off_plane(double distance, double degrees) {
  return worst_of(500, 770, [=](Trial& t) {
    const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
    const glm::vec4 plane = tilted_plane(t, distance, degrees);
    const glm::mat4 oblique = oblique_projection(frustum.projection(), plane);
    double worst = 0;
    for (int i = 0; i < 20; ++i)
      if (const auto p = on_plane(t, frustum, plane)) {
        const glm::dvec2 clip = depth_and_w(oblique, *p);
        worst = std::max(worst, std::abs(clip.x + clip.y) / clip.y);
      }
    return worst;
  });
}

/// The same of the far corners: the largest of their z / w is 1. The far plane is that of the rounded projection.
double off_corner(double distance, double degrees) {
  return worst_of(500, 771, [=](Trial& t) {
    const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
    const glm::vec4 plane = tilted_plane(t, distance, degrees);
    const glm::mat4 projection = frustum.projection(), oblique = oblique_projection(projection, plane);
    const double far = double(projection[3][2]) / (double(projection[2][2]) + 1);
    double largest = -double(infinite);
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) {
        const glm::dvec3 corner(far * x / double(projection[0][0]), far * y / double(projection[1][1]), -far);
        const glm::dvec2 clip = depth_and_w(oblique, corner);
        largest = std::max(largest, clip.x / clip.y);
      }
    return std::abs(largest - 1);
  });
}

}  // namespace

void add_oblique_rows(Table& table) {
  Group group = table.of("oblique_projection");
  for (const double distance : {1e-4, 1e-2, 1.0, 1e3})
    for (const double degrees : {0.0, 60.0, 89.0}) {
      group.close(
          fmt::format("500 planes {:g} m from the eye, tilted by {:g} degrees: z = -w on them", distance, degrees),
          {64 * rounding_unit, "of w",
           "four terms of a row, each rounded twice, up to five times as large as w where the plane is steep"},
          [=] { return off_plane(distance, degrees); });
      group.close(fmt::format("{:g} m, {:g} degrees: z = w at the farthest corner", distance, degrees),
                  {(64 + 16 * distance / 0.1) * rounding_unit, "of w",
                   "who inverts the projection in floats finds 1 / far as a difference of numbers like 1 / near (0.1 "
                   "m): that much of the plane's distance, and a row's roundings"},
                  [=] { return off_corner(distance, degrees); });
    }
  group.equals("x, y and w stay, to the last bit: others of 1000",
               [] {
                 return Values{worst_of(1000, 772, [](Trial& t) {
                   const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
                   const glm::mat4 p = frustum.projection();
                   const double distance = t.size_between(1e-4, 1e3);
                   const glm::mat4 o = oblique_projection(p, tilted_plane(t, distance, t.between(0, 89)));
                   double others = 0;
                   for (int column = 0; column < 4; ++column)
                     for (const int row : {0, 1, 3}) others += p[column][row] != o[column][row];
                   return others;
                 })};
               },
               {0});
  group.equals(
      "points a ten-thousandth before and behind the plane: clipped or not, wrong of 1000",
      [] {
        return Values{worst_of(1000, 773, [](Trial& t) {
          const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
          const glm::vec4 plane = tilted_plane(t, t.size_between(1e-4, 1e3), t.between(0, 80));
          const glm::mat4 oblique = oblique_projection(frustum.projection(), plane);
          const auto p = on_plane(t, frustum, plane, 0.1);
          if (!p) return 0.0;
          const glm::dvec2 before = depth_and_w(oblique, *p * (1 - 1e-4) - 1e-4 * glm::dvec3(plane) * double(-plane.w));
          const glm::dvec2 behind = depth_and_w(oblique, *p * (1 + 1e-4) + 1e-4 * glm::dvec3(plane) * double(-plane.w));
          return double(before.x >= -before.y) + double(behind.x <= -behind.y);
        })};
      },
      {0});
  for (const double far : {1.0, 1e2, 1e4})
    group.close(fmt::format("the near plane itself, far / near {:g}: the projection", far / 0.1),
                {16 * rounding_unit, "absolute",
                 "a scaled row: the error of 1 / far is like that of 1 / near, where the plane is"},
                [=] {
                  const Frustum frustum{1, 0.75, 0.1, far};
                  return difference(values(oblique_projection(frustum.projection(), {0, 0, -1, -0.1f})),
                                    values(frustum.projection()));
                });
}

}  // namespace atelier::stability
