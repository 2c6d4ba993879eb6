// regions: pictures of one pixel, row or column, boards, combs, spirals, even pictures of the largest size, thresholds
// at the magnitude of a step and at the greatest of all.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

using artstyles::Greys;
using artstyles::regions;

namespace {

template <class Value>
Greys drawn_greys(int width, int height, const Value& value) {
  Greys greys{width, height, {}};
  greys.values.reserve(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) greys.values.push_back(std::uint8_t(value(x, y)));
  return greys;
}

Greys noise(int width, int height, int low, int high) {
  return drawn_greys(width, height,
                     [=](int x, int y) { return Trial(1220, std::int64_t(y) * width + x).between(low, high + 1); });
}

/// The square of the magnitude, by differences of smoothed columns and rows.
std::int64_t magnitude_squared(const Greys& greys, int x, int y) {
  const auto grey = [&](int dx, int dy) {
    const int u = std::clamp(x + dx, 0, greys.width - 1), v = std::clamp(y + dy, 0, greys.height - 1);
    return std::int64_t(greys.values[std::size_t(v) * std::size_t(greys.width) + std::size_t(u)]);
  };
  const auto column = [&](int dx) { return grey(dx, -1) + 2 * grey(dx, 0) + grey(dx, 1); };
  const auto row = [&](int dy) { return grey(-1, dy) + 2 * grey(0, dy) + grey(1, dy); };
  const std::int64_t across = column(1) - column(-1), down = row(1) - row(-1);
  return across * across + down * down;
}

/// Each region is filled from its first pixel, with a list of pixels still to visit; they are numbered 1, 2, ...
std::vector<int> filled_regions(const Greys& greys, int threshold) {
  const std::int64_t limit = std::int64_t(threshold) * threshold;
  std::vector<int> numbers(greys.values.size(), -1);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (magnitude_squared(greys, int(i) % greys.width, int(i) / greys.width) > limit) numbers[i] = 0;
  int last = 0;
  std::vector<glm::ivec2> to_visit;
  for (std::size_t first = 0; first < numbers.size(); ++first) {
    if (numbers[first] >= 0) continue;
    ++last;
    to_visit.emplace_back(int(first) % greys.width, int(first) / greys.width);
    while (!to_visit.empty()) {
      const glm::ivec2 at = to_visit.back();
      to_visit.pop_back();
      if (at.x < 0 || at.y < 0 || at.x >= greys.width || at.y >= greys.height) continue;
      int& number = numbers[std::size_t(at.y) * std::size_t(greys.width) + std::size_t(at.x)];
      if (number >= 0) continue;
      number = last;
      for (const glm::ivec2& step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
        to_visit.push_back(at + step);
    }
  }
  return numbers;
}

/// Numbered by their first pixels: 1, 2, ...; what is not above 0 stays.
std::vector<int> in_order(const std::vector<int>& numbers) {
  std::vector<int> order(numbers), out;
  std::ranges::sort(order);
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::vector<int> known(order.size(), 0);
  int last = 0;
  for (const int n : numbers) {
    int& as = known[std::size_t(std::ranges::lower_bound(order, n) - order.begin())];
    if (n > 0 && as == 0) as = ++last;
    out.push_back(n > 0 ? as : n);
  }
  return out;
}

/// How many pixels are in a wrong region, and how many regions there are.
Values wrong_and_count(const Greys& greys, int threshold) {
  const std::vector<int> found = in_order(regions(greys, threshold)), right = filled_regions(greys, threshold);
  if (found.size() != right.size()) return {double(INFINITY), 0};
  double wrong = 0;
  for (std::size_t i = 0; i < right.size(); ++i) wrong += found[i] != right[i];
  return {wrong, double(*std::ranges::max_element(found))};
}

double count_wrong(const Greys& greys, int threshold) {
  return wrong_and_count(greys, threshold)[0];
}

/// A wall of 2 pixels that winds inwards, 6 pixels apart: between its windings there is one way. At the edges of the
/// picture the wall is 1 pixel wide, since 2 would have no gradient there.
Greys spiral(int side) {
  Greys greys = drawn_greys(side, side, [](int, int) { return 255; });
  const auto paint = [&](const glm::ivec2& at) {
    for (int i = 0; i < 4; ++i) {
      const glm::ivec2 p = at + glm::ivec2(i % 2, i / 2);
      if (p.x < 0 || p.y < 0 || p.x >= side || p.y >= side) continue;
      greys.values[std::size_t(p.y) * std::size_t(side) + std::size_t(p.x)] = 0;
    }
  };
  glm::ivec2 at(-1, -1), way(1, 0);
  // The first three legs are as long as the picture, and each pair after them is 6 shorter.
  int length = side;
  for (int leg = 0; length > 0; ++leg) {
    for (int i = 0; i < length; ++i, at += way) paint(at);
    way = {-way.y, way.x};
    if (leg >= 2 && leg % 2 == 0) length -= 6;
  }
  return greys;
}

/// Gaps between walls of 2 pixels, all joined below: many numbers that turn out to be one.
Greys comb(int gaps, int height) {
  return drawn_greys(6 * gaps, height, [=](int x, int y) { return (x + 1) % 6 < 2 && y < height - 6 ? 0 : 255; });
}

void add_threshold_rows(Group& group) {
  for (const int step : {1, 37, 255}) {
    const auto borders = [=](int threshold) {
      const Greys greys = drawn_greys(10, 5, [=](int x, int) { return x < 5 ? 255 - step : 255; });
      return double(std::ranges::count(regions(greys, threshold), 0));
    };
    group.equals(fmt::format("a step of {0} codes: borders at a threshold of 4 x {0}, and of one less", step),
                 [=] {
                   return Values{borders(4 * step), borders(4 * step - 1)};
                 },
                 {0, 10});
  }
  group.equals("the greatest magnitude, 1140.4: borders in the middle at thresholds of 1140 and 1141",
               [] {
                 // White above, and to the right of the middle.
                 const Greys greys =
                     drawn_greys(3, 3, [](int x, int y) { return y == 0 || (y == 1 && x == 2) ? 255 : 0; });
                 return Values{double(regions(greys, 1140).at(4) == 0), double(regions(greys, 1141).at(4) == 0)};
               },
               {1, 0});
  for (const int threshold : {1141, 65'536, largest_int})
    group.equals(fmt::format("noise, a threshold of {}: wrong pixels, regions", threshold),
                 [=] { return wrong_and_count(noise(60, 40, 0, 255), threshold); }, {0, 1});
}

}  // namespace

void add_regions_rows(Table& table) {
  Group group = table.of("regions");
  for (const int value : {0, 128, 255})
    for (const int threshold : {0, 1140})
      for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(1, 4096), glm::ivec2(4096, 1), glm::ivec2(50, 30)})
        group.equals(
            fmt::format("an even picture of {}, {} x {}, a threshold of {}: wrong pixels, regions", value, size.x,
                        size.y, threshold),
            [=] { return wrong_and_count(drawn_greys(size.x, size.y, [=](int, int) { return value; }), threshold); },
            {0, 1});
  group.equals("an even picture of 4096 x 4096: pixels that are not in the region of the first, or in none",
               [] {
                 const std::vector<int> found = regions(drawn_greys(4096, 4096, [](int, int) { return 200; }), 0);
                 const int first = found.empty() ? 0 : found.front();
                 return Values{double(found.size()) - 4096.0 * 4096, double(first <= 0),
                               double(std::ranges::count_if(found, [=](int n) { return n != first; }))};
               },
               {0, 0, 0});
  for (const int side : {61, 1001})
    group.equals(fmt::format("a way that winds inwards, {0} x {0}: wrong pixels, regions", side),
                 [=] { return wrong_and_count(spiral(side), 100); }, {0, 1});
  group.equals("200 gaps between walls, joined below: wrong pixels, regions",
               [] { return wrong_and_count(comb(200, 60), 100); }, {0, 1});
  for (const int side : {1, 2, 3, 4, 7})
    for (const int threshold : {0, 100, 509, 510, 765, 1019, 1020, 1140})
      group.equals(
          fmt::format("a checker board with squares of {}, a threshold of {}: wrong pixels", side, threshold),
          [=] {
            return Values{count_wrong(
                drawn_greys(40, 30, [=](int x, int y) { return (x / side + y / side) % 2 ? 255 : 0; }), threshold)};
          },
          {0});
  for (const glm::ivec2& size : {glm::ivec2(1, 2000), glm::ivec2(2000, 1), glm::ivec2(2, 2), glm::ivec2(150, 100)})
    for (const int threshold : {0, 1, 100, 300, 600, 1140})
      group.equals(fmt::format("noise, {} x {}, a threshold of {}: wrong pixels", size.x, size.y, threshold),
                   [=] {
                     return Values{count_wrong(noise(size.x, size.y, 0, 255), threshold) +
                                   count_wrong(noise(size.x, size.y, 100, 180), threshold)};
                   },
                   {0});
  add_threshold_rows(group);
}

}  // namespace atelier::stability
