// side_planes: distances of points from both planes, for paintings from a millimetre to a kilometre, up to a million
// metres from the origin.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

long double distance_from(const glm::dvec4& plane, const Exact& p) {
  return glm::dot(Exact(glm::dvec3(plane)), p) + static_cast<long double>(plane.w);
}

/// How far off the distances of a point from the two planes are, in the order that fits.
double distance_error(const glm::dmat4& frame, double half_width, const Exact& local) {
  const std::array<glm::dvec4, 2> planes = side_planes(frame, {half_width, 1});
  const Exact p(glm::dvec3(at(frame, local)));
  const long double x = within(frame, p).x, left = half_width + x, right = half_width - x;
  const long double first = distance_from(planes[0], p), second = distance_from(planes[1], p);
  return double(std::min(std::max(std::abs(first - left), std::abs(second - right)),
                         std::max(std::abs(first - right), std::abs(second - left))));
}

double normal_error(const glm::dmat4& frame, double half_width) {
  double worst = 0;
  for (const glm::dvec4& plane : side_planes(frame, {half_width, 1})) {
    const Exact n{glm::dvec3(plane)};
    worst = std::max({worst, std::abs(double(glm::length(n) - 1)), std::abs(double(glm::dot(n, axis(frame, 2)))),
                      std::abs(double(n.y))});
  }
  return worst;
}

}  // namespace

void add_side_rows(Table& table) {
  Group group = table.of("side_planes");
  for (const double distance : {1.0, 1e3, million})
    for (const double half_width : {1e-3, 1.0, 1e3}) {
      const std::string words = fmt::format("1000 frames {:g} m away, {:g} m wide", distance, 2 * half_width);
      group.close(words + ": distances of points 10 m around",
                  metres(distance + half_width + 10, "three products of that size are summed to each plane's offset"),
                  [=] {
                    return worst_of(1000, 2040, [=](Trial& t) {
                      const glm::dmat4 frame = upright_frame(t, distance);
                      return distance_error(frame, half_width, Exact(10.0 * t.direction()));
                    });
                  });
      group.close(words + ": normals of unit length, square to the painting and level",
                  {4 * double_unit, "absolute", "the frame's axes are rounded once"}, [=] {
                    return worst_of(1000, 2041,
                                    [=](Trial& t) { return normal_error(upright_frame(t, distance), half_width); });
                  });
    }
  group.equals(
      "quarter turns and dyadic places up to 2048 m along each axis: the error, and on the sides",
      [] {
        return Values{worst_of(1000, 2042, [](Trial& t) {
          const glm::dmat4 frame = quarter_frame(t, 2048);
          const Exact local(dyadic_place(t, 64));
          return std::max({distance_error(frame, 1.25, local), distance_error(frame, 1.25, {1.25, local.y, local.z}),
                           distance_error(frame, 1.25, {-1.25, local.y, local.z})});
        })};
      },
      {0});
}

}  // namespace atelier::stability
