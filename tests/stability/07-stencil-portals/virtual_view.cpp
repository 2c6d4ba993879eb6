// virtual_view: what the camera sees of points is what the virtual camera sees of their images.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

/// Where a view has a point, in double precision.
glm::dvec3 seen(const glm::mat4& view, const glm::dvec3& p) {
  return glm::dvec3(glm::dmat4(view) * glm::dvec4(p, 1));
}

/// The largest difference between what the camera sees of points and what the virtual camera sees of their images, as
/// a share of how far from the origin all of that is.
template <class Make>
double view_error(double distance, bool quarters, Make make) {
  return worst_of(1000, 710, [=](Trial& t) {
    const auto [passage, exact, place] = make(t, distance, quarters);
    const glm::dmat4 camera = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
    const glm::mat4 view = view_of(camera), inside = virtual_view(view, passage);
    const glm::dvec3 p = quarters ? dyadic_place(t, distance) : place + 10.0 * t.direction();
    return largest_of(Exact(seen(inside, glm::dvec3(exact(Exact(p))))) - Exact(seen(view, p))) / (distance + 10);
  });
}

}  // namespace

void add_view_rows(Table& table) {
  Group group = table.of("virtual_view");
  const Bound rounded{12 * rounding_unit, "of the distance",
                      "each of three turns and a shift is rounded, and the points are that far away, twice"};
  for (const double distance : {1.0, 1e3, million}) {
    group.close(fmt::format("1000 portals {:g} m from the origin: images are seen where the points are", distance),
                rounded, [=] { return view_error(distance, false, some_portal); });
    group.close(fmt::format("1000 mirrors {:g} m from the origin", distance), rounded,
                [=] { return view_error(distance, false, some_mirror); });
  }
  group.equals("quarter turns and dyadic places up to 1024 m, portals and mirrors: the error",
               [] {
                 return Values{view_error(1024, true, some_portal), view_error(1024, true, some_mirror)};
               },
               {0, 0});
  group.close("a view that a mirror has turned round has a determinant of -1",
              {8 * rounding_unit, "absolute", "nine rounded entries"}, [] {
                return worst_of(1000, 711, [](Trial& t) {
                  const glm::mat4 view = view_of(odd_frame(t, 5));
                  return std::abs(determinant_of(glm::dmat4(virtual_view(view, mirror_passage(odd_frame(t, 5))))) + 1);
                });
              });
  group.close("the mirror in the mirror: the camera's own view, 100 m away",
              {16 * rounding_unit * 100, "absolute", "two rounded views one after the other"}, [] {
                return worst_of(1000, 712, [](Trial& t) {
                  const glm::mat4 view = view_of(odd_frame(t, 100));
                  const glm::dmat4 passage = mirror_passage(odd_frame(t, 100));
                  return difference(values(virtual_view(virtual_view(view, passage), passage)), values(view));
                });
              });
}

}  // namespace atelier::stability
