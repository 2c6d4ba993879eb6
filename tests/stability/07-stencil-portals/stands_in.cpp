// stands_in: boxes and sheets from a millimetre to a thousand kilometres, in openings of all sizes and next to them.
// Each stands where the contract fixes the answer: more than its 1e-6 m from every limit.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

constexpr double gap = 2e-6;  ///< metres: twice what is free

/// An opening, and a body: a box with these half extents along the axes of a frame.
struct Meeting {
  glm::dmat4 opening{1}, body{1};
  glm::dvec2 half_size{0};
  glm::dvec3 extents{0};
};

/// The opening `distance` metres from the origin. A sheet has no thickness.
Meeting some_meeting(Trial& t, double distance, bool sheet) {
  Meeting m{.opening = odd_frame(t, distance), .body = odd_frame(t, 0)};
  for (int i = 0; i < 2; ++i) m.half_size[i] = t.size_between(sheet ? 1e-3 : 1e-6, million);
  for (int i = 0; i < 3; ++i) m.extents[i] = t.size_between(sheet ? 0.1 : 1e-3, million);
  if (sheet) m.extents[int(t.between(0, 3))] = 0;
  return m;
}

/// How far the body reaches from its centre along an axis of the opening.
long double reach(const Meeting& m, int along) {
  long double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::abs(glm::dot(axis(m.body, i), axis(m.opening, along))) * m.extents[i];
  return sum;
}

double answer(const Meeting& m, const Exact& centre) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    Exact corner = centre;
    for (int k = 0; k < 3; ++k)
      corner += static_cast<long double>(i >> k & 1 ? m.extents[k] : -m.extents[k]) * axis(m.body, k);
    corners[i] = glm::dvec3(corner);
  }
  return stands_in(m.opening, m.half_size, corners);
}

/// The answer for a body that holds a point of the opening, a tenth of its extents within its sides.
double answer_in_opening(Trial& t, const Meeting& m) {
  Exact centre = at(m.opening, {0.99 * m.half_size.x * t.between(-1, 1), 0.99 * m.half_size.y * t.between(-1, 1), 0});
  for (int i = 0; i < 3; ++i)
    centre += static_cast<long double>(0.9 * m.extents[i] * t.between(-1, 1)) * axis(m.body, i);
  return answer(m, centre);
}

/// For a body straight before or behind the opening, by the gap.
double answer_on_one_side(Trial& t, const Meeting& m) {
  return answer(m, at(m.opening, {m.half_size.x * t.between(-1, 1), m.half_size.y * t.between(-1, 1),
                                  t.sign() * (gap + reach(m, 2))}));
}

/// For a body that the plane parts, beyond a side of the rectangle by the gap.
double answer_beside(Trial& t, const Meeting& m) {
  Exact centre{m.half_size.x * t.between(-1, 1), m.half_size.y * t.between(-1, 1), reach(m, 2) * t.between(-0.9, 0.9)};
  const int across = int(t.between(0, 2));
  centre[across] = t.sign() * (m.half_size[across] + gap + reach(m, across));
  return answer(m, at(m.opening, centre));
}

/// Boxes along the axes of openings at quarter turns and dyadic places: nothing is rounded.
void add_upright_boxes(Group& group) {
  const auto row = [&](const char* what, const Exact& low, const Exact& high, bool expected) {
    group.equals(std::string(what) + ", 200 frames: others",
                 [=] {
                   return Values{worst_of(200, 804, [=](Trial& t) {
                     const glm::dmat4 frame = quarter_frame(t, 2048);
                     std::array<glm::dvec3, 8> corners;
                     for (std::size_t i = 0; i < 8; ++i)
                       corners[i] = glm::dvec3(
                           at(frame, {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}));
                     return double(stands_in(frame, {1, 1.25}, corners) != expected);
                   })};
                 },
                 {0});
  };
  const long double hair = 1.0L / 1024;
  row("1 mm of it behind the plane", {-0.5L, -0.5L, -hair}, {0.5L, 0.5L, 2}, true);
  row("1 mm of it before the plane", {-0.5L, -0.5L, -2}, {0.5L, 0.5L, hair}, true);
  row("1 mm before the plane", {-0.5L, -0.5L, hair}, {0.5L, 0.5L, 2}, false);
  row("1 mm behind the plane", {-0.5L, -0.5L, -2}, {0.5L, 0.5L, -hair}, false);
  row("1 mm within the right side", {1 - hair, -0.5L, -1}, {3, 0.5L, 1}, true);
  row("1 mm beyond the right side", {1 + hair, -0.5L, -1}, {3, 0.5L, 1}, false);
  row("1 mm within the left side", {-3, -0.5L, -1}, {-1 + hair, 0.5L, 1}, true);
  row("1 mm beyond the left side", {-3, -0.5L, -1}, {-1 - hair, 0.5L, 1}, false);
  row("1 mm within the upper side", {-0.5L, 1.25L - hair, -1}, {0.5L, 3, 1}, true);
  row("1 mm above the upper side", {-0.5L, 1.25L + hair, -1}, {0.5L, 3, 1}, false);
  row("1 mm within the lower side", {-0.5L, -3, -1}, {0.5L, -1.25L + hair, 1}, true);
  row("1 mm below the lower side", {-0.5L, -3, -1}, {0.5L, -1.25L - hair, 1}, false);
  row("a plank across the opening", {-8, 0, -hair}, {8, hair, hair}, true);
  row("larger than the opening on all sides", {-1024, -1024, -1024}, {1024, 1024, 1024}, true);
  row("a sheet across the opening", {-8, 0, -1}, {8, 0, 1}, true);
  row("a sheet along the plane, 1 mm behind it", {-8, -8, -hair}, {8, 8, -hair}, false);
  row("a needle through the opening", {0.5L, 0.5L, -1}, {0.5L, 0.5L, 1}, true);
  row("a needle beside it", {1.5L, 0.5L, -1}, {1.5L, 0.5L, 1}, false);
  row("a point before it", {0.5L, 0.5L, 1}, {0.5L, 0.5L, 1}, false);
  row("a point behind it", {0.5L, 0.5L, -1}, {0.5L, 0.5L, -1}, false);
}

}  // namespace

void add_body_rows(Table& table) {
  Group group = table.of("stands_in");
  for (const double distance : {1.0, million})
    for (const bool sheets : {false, true}) {
      const auto others = [&](const char* where, std::uint64_t seed, auto answer_of, double expected) {
        group.equals(
            fmt::format("2000 {} {}, openings {:g} m away: others", sheets ? "sheets" : "boxes", where, distance),
            [=] {
              return Values{worst_of(2000, seed, [=](Trial& t) {
                return std::abs(answer_of(t, some_meeting(t, distance, sheets)) - expected);
              })};
            },
            {0});
      };
      others("that hold a point of the opening", 800, answer_in_opening, 1);
      others("on one side of the plane, 2e-6 m from it", 801, answer_on_one_side, 0);
      others("that the plane parts, 2e-6 m beside the rectangle", 802, answer_beside, 0);
    }
  add_upright_boxes(group);
  group.equals("an opening without an extent: a box that holds its point, and one beside it",
               [] {
                 const Meeting m{.extents = glm::dvec3(1)};
                 return Values{answer(m, {0.5L, 0.5L, 0.5L}), answer(m, {1.001L, 0, 0})};
               },
               {1, 0});
  group.equals("a box 1e-310 m wide before the opening, behind it and beside it",
               [] {
                 const Meeting m{.half_size = {1, 1}, .extents = glm::dvec3(1e-310)};
                 return Values{answer(m, {0, 0, 1}), answer(m, {0, 0, -1}), answer(m, {2, 0, 0})};
               },
               {0, 0, 0});
}

}  // namespace atelier::stability
