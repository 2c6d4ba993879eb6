#include "stability/08-post-processing/colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier::stability {

namespace {

/// The corner of the colour cube after so many sixths of a turn.
Colour pure_colour(int sixths) {
  constexpr std::array<std::array<double, 3>, 6> corners = {
      {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}}};
  const auto& corner = corners[std::size_t(sixths % 6)];
  return {corner[0], corner[1], corner[2]};
}

/// std::max and std::min may overlook it.
bool has_nan(const Colour& c) {
  return std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b);
}

bool fits(const Colour& c) {
  return std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= 1;
}

}  // namespace

double luma_of(const Colour& c) {
  return glm::dot(c, Colour(0.2126, 0.7152, 0.0722));
}

double chroma_of(const Colour& c) {
  if (has_nan(c)) return NAN;
  return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
}

double hue_of(const Colour& c) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return c[a] > c[b]; });
  const double chroma = chroma_of(c);
  if (!(chroma > 0)) return 0;
  // From the largest component's primary towards that of the middle one, up to half of the way.
  const double way = (c[order[1]] - c[order[2]]) / chroma;
  const double sixths = (order[0] + 1) % 3 == order[1] ? 2 * order[0] + way : 2 * order[0] - way;
  return (sixths < 0 ? sixths + 6 : sixths) / 6;
}

double turns_between(double a, double b) {
  const double apart = std::abs(a - b), rest = apart - std::floor(apart);
  return std::min(rest, 1 - rest);
}

Colour colour_with(double hue, double chroma, double luma) {
  if (luma >= 1) return Colour(luma);
  const double sixths = 6 * (hue - std::floor(hue));
  const int before = int(sixths);
  const Colour pure = glm::mix(pure_colour(before), pure_colour(before + 1), sixths - before);
  const Colour way = pure - luma_of(pure);
  if (fits(luma + chroma * way)) return luma + chroma * way;
  double inside = 0, outside = chroma;
  for (int i = 0; i < 100; ++i) {
    const double middle = (inside + outside) / 2;
    (fits(luma + middle * way) ? inside : outside) = middle;
  }
  return luma + inside * way;
}

double largest_of(const Colour& c) {
  if (has_nan(c)) return NAN;
  return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)});
}

glm::vec3 some_colour(Trial& t) {
  const double r = t.between(0, 1), g = t.between(0, 1);
  return {r, g, t.between(0, 1)};
}

glm::vec3 some_light(Trial& t, double low, double high) {
  const double r = t.size_between(low, high), g = t.size_between(low, high);
  return {r, g, t.size_between(low, high)};
}

}  // namespace atelier::stability
