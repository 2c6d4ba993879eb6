// goes_through: which movements cross an opening, and how often someone who walks on goes through.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

const glm::dvec2 half_door(1, 1.25);

/// By the volumes between the line and the opening's edges: all are on one side where the line is inside.
bool meets(const glm::dmat4& frame, const glm::dvec2& half_size, const Exact& from, const Exact& to) {
  if (height_above(frame, from) < 0 || height_above(frame, to) >= 0) return false;
  const Exact corners[] = {at(frame, {-half_size.x, -half_size.y, 0}), at(frame, {half_size.x, -half_size.y, 0}),
                           at(frame, {half_size.x, half_size.y, 0}), at(frame, {-half_size.x, half_size.y, 0})};
  int before = 0;
  for (int i = 0; i < 4; ++i)
    before += glm::dot(glm::cross(corners[i] - from, corners[(i + 1) % 4] - corners[i]), to - from) <= 0;
  return before == 4;
}

/// Of `count` movements of this length about a frame, how many the function judges wrongly; those that rounding may
/// decide are left out, and less than half of them may be. `steepest` is the largest slope against the plane, 1 for
/// any.
double misjudged(int count, double distance, double length, double steepest) {
  int wrong = 0, judged = 0;
  for (int i = 0; i < count; ++i) {
    Trial t(740, i);
    const glm::dmat4 frame = odd_frame(t, distance);
    const double z = -steepest * t.between(0.1, 1), angle = t.between(0, 2 * std::numbers::pi);
    const double flat = std::sqrt(1 - z * z), before = t.between(-0.5, 1.5);
    const Exact met(1.5 * half_door.x * t.between(-1, 1), 1.5 * half_door.y * t.between(-1, 1), 0);
    const Exact along = static_cast<long double>(length) * Exact(flat * std::cos(angle), flat * std::sin(angle), z);
    const glm::dvec3 from(at(frame, met - static_cast<long double>(before) * along));
    const glm::dvec3 to(at(frame, met + static_cast<long double>(1 - before) * along));
    const double noise = 32 * double_unit * (distance + length + 2), aside = noise / std::abs(z);
    const double a = double(height_above(frame, Exact(from))), b = double(height_above(frame, Exact(to)));
    if (std::abs(a) < noise || std::abs(b) < noise) continue;
    const bool certain = meets(frame, half_door - aside, Exact(from), Exact(to));
    if (certain != meets(frame, half_door + aside, Exact(from), Exact(to))) continue;
    wrong += goes_through(frame, half_door, from, to) != certain;
    ++judged;
  }
  return judged < count / 2 ? double(infinite) : double(wrong);
}

/// How often someone goes through who walks straight on through an opening in steps of this length, first before it,
/// at last behind it.
double times_through(const glm::dmat4& frame, double step, double offset) {
  double times = 0;
  for (int k = -50; k < 50; ++k) {
    const glm::dvec3 from(at(frame, {0.25L, 0.5L, -static_cast<long double>(k * step + offset)}));
    const glm::dvec3 to(at(frame, {0.25L, 0.5L, -static_cast<long double>((k + 1) * step + offset)}));
    times += goes_through(frame, half_door, from, to);
  }
  return times;
}

}  // namespace

void add_through_rows(Table& table) {
  Group group = table.of("goes_through");
  struct Case {
    double distance, length, steepest;
    const char* words;
  };
  for (const Case& c :
       {Case{1, 1e-9, 1, "1e-9 m"}, Case{1, 1, 1, "1 m"}, Case{1, 1e7, 1, "1e7 m"},
        Case{million, 1, 1, "1 m, a million metres away"}, Case{million, 1e-6, 1, "1e-6 m, a million metres away"},
        Case{million, 1e7, 1, "1e7 m, a million metres away"}, Case{1, 1, 1e-6, "1 m, a millionth out of the plane"},
        Case{1, 1e7, 1e-5, "1e7 m, a hundred-thousandth out of the plane"}})
    group.equals(fmt::format("4000 movements of {}: misjudged", c.words),
                 [=] { return Values{misjudged(4000, c.distance, c.length, c.steepest)}; }, {0});

  // Quarter turns and dyadic places: nothing is rounded.
  const auto row = [&](const char* what, const Exact& from, const Exact& to, bool expected) {
    group.equals(std::string(what) + ", 200 frames: others",
                 [=] {
                   return Values{worst_of(200, 741, [=](Trial& t) {
                     const glm::dmat4 frame = quarter_frame(t, 2048);
                     return double(goes_through(frame, half_door, glm::dvec3(at(frame, from)),
                                                glm::dvec3(at(frame, to))) != expected);
                   })};
                 },
                 {0});
  };
  const long double x = half_door.x, y = half_door.y, hair = 1.0L / 1024;
  row("straight through a corner", {x, y, 3}, {x, y, -7}, true);
  row("at an angle through a corner", {-x - 2, -y + 1, 0.5L}, {-x + 2, -y - 1, -0.5L}, true);
  row("through the rim", {x, 0, 0.25L}, {x, 0, -0.25L}, true);
  row("1 mm beside the rim", {x + hair, 0, 0.25L}, {x + hair, 0, -0.25L}, false);
  row("1 mm above the rim", {0, -y - hair, 0.25L}, {0, -y - hair, -0.25L}, false);
  row("from the plane to behind it", {0.5L, 0.5L, 0}, {5, 5, -1}, true);
  row("from the plane beside the opening", {x + 1, 0, 0}, {0, 0, -1}, false);
  row("from before onto the plane", {0, 0, 1}, {0, 0, 0}, false);
  row("along the plane, in it", {-x, 0, 0}, {x, 0, 0}, false);
  row("along the plane, before it", {-5, 0, hair}, {5, 0, hair}, false);
  row("along the plane, behind it", {-5, 0, -hair}, {5, 0, -hair}, false);
  row("no movement on the plane", {0.5L, 0, 0}, {0.5L, 0, 0}, false);
  row("no movement before it", {0.5L, 0, 1}, {0.5L, 0, 1}, false);
  row("no movement behind it", {0.5L, 0, -1}, {0.5L, 0, -1}, false);
  row("from behind to before", {0, 0, -1}, {0, 0, 1}, false);
  row("from behind onto the plane", {0, 0, -1}, {0, 0, 0}, false);
  row("from far before to a hair behind", {0, 0, 2048}, {0, 0, -hair}, true);

  group.equals("a walk with a halt on the plane, quarter turns: times through, most and least",
               [] {
                 double least = 9, most = 0;
                 for (int i = 0; i < 200; ++i) {
                   Trial t(742, i);
                   const double times = times_through(quarter_frame(t, 2048), 1.0 / 1024, 0);
                   least = std::min(least, times), most = std::max(most, times);
                 }
                 return Values{least, most};
               },
               {1, 1});
  group.equals("walks in steps of 1e-8 m, odd frames a million metres away: times through, most and least",
               [] {
                 double least = 9, most = 0;
                 for (int i = 0; i < 200; ++i) {
                   Trial t(743, i);
                   const double times = times_through(odd_frame(t, million), 1e-8, 1e-8 * t.between(0, 1));
                   least = std::min(least, times), most = std::max(most, times);
                 }
                 return Values{least, most};
               },
               {1, 1});
  group.equals("an opening without an extent: through its point, and beside it",
               [] {
                 const glm::dmat4 frame(1);
                 return Values{double(goes_through(frame, {0, 0}, {0, 0, 1}, {0, 0, -1})),
                               double(goes_through(frame, {0, 0}, {1e-300, 0, 1}, {1e-300, 0, -1}))};
               },
               {1, 0});
}

}  // namespace atelier::stability
