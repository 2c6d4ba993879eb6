// plane_in_view: both distances of a point, in world space and in view space.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

/// A view that turns, or turns and reflects.
glm::mat4 some_view(const glm::dmat4& camera, bool reflecting) {
  glm::mat4 view = view_of(camera);
  if (reflecting)
    for (int column = 0; column < 4; ++column) view[column][0] = -view[column][0];
  return view;
}

}  // namespace

void add_plane_in_view_rows(Table& table) {
  Group group = table.of("plane_in_view");
  // How far apart both distances of a point are.
  const auto error = [](const glm::dvec4& plane, const glm::mat4& view, const glm::dvec3& p) {
    const glm::vec4 found = plane_in_view(plane, view);
    const glm::vec<4, long double> v(glm::dmat4(view) * glm::dvec4(p, 1));
    return std::abs(double(glm::dot(glm::vec<4, long double>(found), v) -
                           glm::dot(glm::vec<4, long double>(plane), glm::vec<4, long double>(p, 1))));
  };
  for (const bool reflecting : {false, true})
    for (const double size : {1e-3, 1.0, 1e3})
      group.close(
          fmt::format("1000 odd {}views and planes, all within {:g} m", reflecting ? "reflecting " : "", size),
          {16 * rounding_unit, "of that size",
           "the view's nine entries are rounded, then the plane's four, and points are up to 4 sizes from the eye"},
          [=] {
            return worst_of(1000, 760, [=](Trial& t) {
              const glm::dmat4 frame = odd_frame(t, size), camera = odd_frame(t, size);
              const glm::dvec4 plane(glm::dvec3(frame[2]), double(-glm::dot(axis(frame, 2), origin(frame))));
              return error(plane, some_view(camera, reflecting), t.in_cube(size)) / size;
            });
          });
  for (const bool reflecting : {false, true})
    group.equals(fmt::format("quarter turns and dyadic places a million metres away{}: the error",
                             reflecting ? ", reflecting" : ""),
                 [=] {
                   return Values{worst_of(1000, 761, [=](Trial& t) {
                     glm::dmat4 camera = quarter_frame(t, 0), frame = quarter_frame(t, 16);
                     const glm::dvec3 place = million * glm::dvec3(t.sign(), t.sign(), t.sign());
                     camera[3] = glm::dvec4(place, 1);
                     frame[3] += glm::dvec4(place, 0);
                     const glm::dvec4 plane(glm::dvec3(frame[2]), double(-glm::dot(axis(frame, 2), origin(frame))));
                     return error(plane, some_view(camera, reflecting), place + dyadic_place(t, 64));
                   })};
                 },
                 {0});
}

}  // namespace atelier::stability
