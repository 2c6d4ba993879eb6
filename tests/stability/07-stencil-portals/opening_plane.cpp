// opening_plane: distances of points from the plane, and its sides.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

void add_plane_rows(Table& table) {
  Group group = table.of("opening_plane");
  const auto error = [](const glm::dmat4& frame, const Exact& local, bool from_behind) {
    const glm::dvec4 plane = opening_plane(frame, from_behind);
    const Exact p(glm::dvec3(at(frame, local)));
    const long double expected = height_above(frame, p) * (from_behind ? -1 : 1);
    return std::abs(double(glm::dot(Exact(glm::dvec3(plane)), p) + static_cast<long double>(plane.w) - expected));
  };
  for (const double distance : {1.0, million})
    for (const bool behind : {false, true})
      group.close(
          fmt::format("1000 odd frames {:g} m away, points 10 m around{}", distance, behind ? ", from behind" : ""),
          metres(distance + 10, "three products of that size are summed to the plane's offset"), [=] {
            return worst_of(1000, 720, [=](Trial& t) {
              const glm::dmat4 frame = odd_frame(t, distance);
              return error(frame, Exact(10.0 * t.direction()), behind);
            });
          });
  group.equals("quarter turns and dyadic places up to 2048 m along each axis: the error, and on the plane",
               [=] {
                 return Values{worst_of(1000, 721, [=](Trial& t) {
                   const glm::dmat4 frame = quarter_frame(t, 2048);
                   const Exact local(dyadic_place(t, 64));
                   return std::max({error(frame, local, false), error(frame, local, true),
                                    error(frame, {local.x, local.y, 0}, false)});
                 })};
               },
               {0});
}

}  // namespace atelier::stability
