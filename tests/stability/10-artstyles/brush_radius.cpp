// brush_radius: black, even and nearly even pictures, a reach of 0 and beyond the picture, contrasts of 1e-6 to 1e6.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

using artstyles::Brush;
using artstyles::brush_radius;
using artstyles::Greys;

namespace {

constexpr int far_reach = 100'000;

Greys even_greys(int width, int height, int value) {
  return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height), std::uint8_t(value))};
}

std::uint8_t& grey_at(Greys& greys, int x, int y) {
  return greys.values[std::size_t(y) * std::size_t(greys.width) + std::size_t(x)];
}

Greys random_greys(int width, int height, int low, int high, std::uint64_t seed) {
  Greys greys = even_greys(width, height, 0);
  for (std::size_t i = 0; i < greys.values.size(); ++i)
    greys.values[i] = std::uint8_t(Trial(seed, std::int64_t(i)).between(low, high + 1));
  return greys;
}

/// How far the radius is from the exact one, which is no whole number: the deviation in two passes, in double
/// precision.
double radius_error(const Greys& greys, glm::ivec2 centre, const Brush& brush) {
  std::vector<double> values;
  for (std::int64_t y = std::max(centre.y - brush.reach, 0);
       y <= std::min<std::int64_t>(std::int64_t(centre.y) + brush.reach, greys.height - 1); ++y)
    for (std::int64_t x = std::max(centre.x - brush.reach, 0);
         x <= std::min<std::int64_t>(std::int64_t(centre.x) + brush.reach, greys.width - 1); ++x)
      values.push_back(greys.values[std::size_t(y) * std::size_t(greys.width) + std::size_t(x)]);
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = sum / double(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double contrast = mean > 0 ? std::sqrt(squares / double(values.size())) / mean : 0;
  const double exact = brush.largest + (brush.smallest - brush.largest) * std::min(contrast / double(brush.full), 1.0);
  const int found = brush_radius(greys, centre, brush);
  if (found < brush.smallest || found > brush.largest) return double(INFINITY);
  return std::abs(found - exact);
}

const Bound nearest{0.5 + 1e-9, "pixels", "the nearest whole number, half way either, and the roundings of doubles"};

/// How many of the even pictures of all greys have another brush than the largest.
double not_largest(int width, int height, const Brush& brush) {
  double others = 0;
  for (int value = 0; value < 256; ++value)
    others += brush_radius(even_greys(width, height, value), {width / 2, height / 2}, brush) != brush.largest;
  return others;
}

}  // namespace

void add_radius_rows(Table& table) {
  Group group = table.of("brush_radius");
  for (const auto& [width, height] : {std::pair{1, 1}, {9, 9}, {40, 3}, {1, 4096}, {4096, 1}})
    for (const int reach : {0, 4, far_reach})
      for (const float full : {1e-6f, 0.5f, 1e6f})
        group.equals(
            fmt::format("even pictures of {} x {}, all greys, a reach of {}, full at {:g}: not the largest", width,
                        height, reach, full),
            [=, width = width, height = height] {
              return Values{not_largest(width, height, {.smallest = 1, .largest = 1000, .reach = reach, .full = full})};
            },
            {0});
  group.equals("white, 2000 x 2000, all of it within reach: not the largest",
               [] {
                 const Brush brush{.smallest = 0, .largest = 1000, .reach = 2000, .full = 1e-6f};
                 return Values{double(brush_radius(even_greys(2000, 2000, 255), {1000, 1000}, brush))};
               },
               {1000});
  for (const int side : {3, 9, 101, 1001})
    group.close(
        fmt::format("white but for one pixel of 254, {0} x {0}: a contrast of {1:.2g} takes a half, a third, a tenth "
                    "of the way",
                    side, 1 / (255.0 * side)),
        nearest, [=] {
          Greys greys = even_greys(side, side, 255);
          grey_at(greys, side / 3, side / 2) = 254;
          double worst = 0;
          for (const float way : {2.0f, 3.0f, 10.0f})
            worst = worse_of(
                worst,
                radius_error(greys, {side / 2, side / 2},
                             {.smallest = 0, .largest = 1000, .reach = side, .full = way / (255 * float(side))}));
          return worst;
        });
  group.equals(
      "4096 x 1, white but for the last pixel, full at 1e-6: with it in reach, and one pixel farther away",
      [] {
        Greys greys = even_greys(4096, 1, 255);
        grey_at(greys, 4095, 0) = 254;
        const auto at = [&](int x, int reach) {
          return double(brush_radius(greys, {x, 0}, {.smallest = 3, .largest = 70, .reach = reach, .full = 1e-6f}));
        };
        return Values{at(4091, 4), at(4090, 4), at(4095, 0), at(0, 4095), at(0, 4094), at(2000, far_reach)};
      },
      {3, 70, 70, 3, 70, 3});
  group.equals("one white pixel in black, 101 x 101: with it in reach, and beside it",
               [] {
                 Greys greys = even_greys(101, 101, 0);
                 grey_at(greys, 50, 50) = 255;
                 const auto at = [&](int x, int y) {
                   return double(brush_radius(greys, {x, y}, {.smallest = 2, .largest = 8, .reach = 4, .full = 8.9f}));
                 };
                 // 81 pixels, one of which is white: a contrast of the root of 80, 8.94.
                 return Values{at(50, 50), at(46, 54), at(54, 46), at(55, 50), at(50, 45)};
               },
               {2, 2, 2, 8, 8});
  group.equals(
      "half black, half 200: a contrast of 1, full at 1, 2, 4, and at a float less",
      [] {
        Greys greys = even_greys(10, 6, 0);
        for (int i = 0; i < 60; i += 2) greys.values[std::size_t(i)] = 200;
        const auto at = [&](float full) {
          return double(brush_radius(greys, {5, 3}, {.smallest = 2, .largest = 10, .reach = far_reach, .full = full}));
        };
        return Values{at(1), at(2), at(4), at(std::nextafter(1.0f, 0.0f)), at(1e-6f), at(1e6f)};
      },
      {2, 6, 8, 2, 2, 10});
  group.equals("noise, full at 1e-6 and at 1e6, brushes of equal size, a reach of 0",
               [] {
                 const Greys greys = random_greys(30, 20, 0, 255, 1200);
                 const auto at = [&](const Brush& brush) { return double(brush_radius(greys, {17, 9}, brush)); };
                 return Values{at({.smallest = 0, .largest = 1000, .reach = 4, .full = 1e-6f}),
                               at({.smallest = 0, .largest = 1000, .reach = 4, .full = 1e6f}),
                               at({.smallest = 5, .largest = 5, .reach = 4, .full = 0.5f}),
                               at({.smallest = 0, .largest = 0, .reach = 4, .full = 0.5f}),
                               at({.smallest = 1, .largest = 6, .reach = 0, .full = 1e-6f})};
               },
               {0, 1000, 5, 0, 6});
  for (const auto& [low, high] : {std::pair{0, 255}, {0, 1}, {254, 255}, {250, 255}, {100, 101}})
    for (const int reach : {1, 4, 60})
      group.close(fmt::format("noise of {} to {}, a reach of {}, 300 brushes", low, high, reach), nearest,
                  [=, low = low, high = high] {
                    const Greys greys = random_greys(64, 48, low, high, 1201);
                    return worst_of(300, 1202, [&](Trial& t) {
                      const glm::ivec2 centre(int(t.between(0, 64)), int(t.between(0, 48)));
                      const int smallest = int(t.between(0, 20));
                      const Brush brush{.smallest = smallest,
                                        .largest = smallest + int(t.between(0, 1000)),
                                        .reach = reach,
                                        .full = float(t.size_between(1e-4, 3))};
                      return radius_error(greys, centre, brush);
                    });
                  });
  group.close("noise of 254 to 255, 1500 x 1500, all of it within reach: the nearest of 1000 brushes", nearest, [] {
    const Greys greys = random_greys(1500, 1500, 254, 255, 1203);
    return radius_error(greys, {0, 1499}, {.smallest = 0, .largest = 1000, .reach = far_reach, .full = 0.005f});
  });
}

}  // namespace atelier::stability
