// portal_passage and mirror_passage: points, there and back, determinants; up to a million metres from the origin.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

/// Adds rows for passages of any kind: make(trial, distance, quarters) is a passage with its exact map.
template <class Make>
void add_passage_rows(Group& group, double determinant, Make make) {
  for (const double distance : {1.0, 1e3, million})
    group.close(fmt::format("1000 odd frames {:g} m from the origin, points 10 m from them", distance),
                metres(2 * (distance + 10), sums_of_products), [=] {
                  return worst_of(1000, 700, [=](Trial& t) {
                    const auto [passage, exact, place] = make(t, distance, false);
                    const glm::dvec3 p = place + 10.0 * t.direction();
                    return largest_of(mapped(passage, p) - exact(Exact(p)));
                  });
                });
  group.equals("1000 frames at quarter turns and dyadic places up to 2048 m along each axis: the error",
               [=] {
                 return Values{worst_of(1000, 701, [=](Trial& t) {
                   const auto [passage, exact, place] = make(t, 2048, true);
                   const glm::dvec3 p = dyadic_place(t, 2048);
                   return largest_of(mapped(passage, p) - exact(Exact(p)));
                 })};
               },
               {0});
  group.close(fmt::format("determinant {:+g}, lengths stay, a million metres away", determinant),
              {32 * double_unit, "absolute", "products of three turns, each of unit vectors with a rounding each"},
              [=] {
                return worst_of(1000, 702, [=](Trial& t) {
                  const glm::dmat4 passage = std::get<0>(make(t, million, false));
                  const glm::dmat3 turn(passage);
                  return std::max(std::abs(determinant_of(passage) - determinant),
                                  difference(values(glm::transpose(turn) * turn), values(glm::dmat3(1))));
                });
              });
}

}  // namespace

std::tuple<glm::dmat4, Map, glm::dvec3> some_portal(Trial& t, double distance, bool quarters) {
  const glm::dmat4 entry = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
  const glm::dmat4 exit = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
  return {portal_passage(entry, exit), [=](const Exact& p) { return through(entry, exit, p); }, glm::dvec3(entry[3])};
}

std::tuple<glm::dmat4, Map, glm::dvec3> some_mirror(Trial& t, double distance, bool quarters) {
  const glm::dmat4 frame = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
  return {mirror_passage(frame), [=](const Exact& p) { return reflected(frame, p); }, glm::dvec3(frame[3])};
}

void add_portal_rows(Table& table) {
  Group group = table.of("portal_passage");
  add_passage_rows(group, 1, some_portal);
  for (const double distance : {1.0, million})
    group.close(fmt::format("there and back, {:g} m away: the identity for points 10 m from the entry", distance),
                metres(4 * (distance + 10), "two passages one after the other"), [=] {
                  return worst_of(1000, 703, [=](Trial& t) {
                    const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
                    const glm::dvec3 p = glm::dvec3(entry[3]) + 10.0 * t.direction();
                    const glm::dvec3 there(mapped(portal_passage(entry, exit), p));
                    return largest_of(mapped(portal_passage(exit, entry), there) - Exact(p));
                  });
                });
  group.close("into the very frame that it comes out of: half a turn about y", metres(20, sums_of_products), [] {
    return worst_of(1000, 704, [](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, 10);
      const Exact local(t.in_cube(5));
      return largest_of(mapped(portal_passage(frame, frame), glm::dvec3(at(frame, local))) -
                        at(frame, {-local.x, local.y, -local.z}));
    });
  });
  group.close("points of the entry's plane come to lie on the exit's, a million metres away",
              metres(2 * million, sums_of_products), [] {
                return worst_of(1000, 705, [](Trial& t) {
                  const glm::dmat4 entry = odd_frame(t, million), exit = odd_frame(t, million);
                  const Exact p = at(entry, {t.between(-5, 5), t.between(-5, 5), 0});
                  return std::abs(double(height_above(exit, mapped(portal_passage(entry, exit), glm::dvec3(p)))));
                });
              });
}

void add_mirror_rows(Table& table) {
  Group group = table.of("mirror_passage");
  add_passage_rows(group, -1, some_mirror);
  group.close("twice, a million metres away: the identity", metres(4 * million, "two passages one after the other"),
              [] {
                return worst_of(1000, 706, [](Trial& t) {
                  const glm::dmat4 frame = odd_frame(t, million), passage = mirror_passage(frame);
                  const glm::dvec3 p = glm::dvec3(frame[3]) + 10.0 * t.direction();
                  return largest_of(mapped(passage, glm::dvec3(mapped(passage, p))) - Exact(p));
                });
              });
  group.close("points of the mirror stay", metres(20, sums_of_products), [] {
    return worst_of(1000, 707, [](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, 10);
      const glm::dvec3 p(at(frame, {t.between(-5, 5), t.between(-5, 5), 0}));
      return largest_of(mapped(mirror_passage(frame), p) - Exact(p));
    });
  });
}

}  // namespace atelier::stability
