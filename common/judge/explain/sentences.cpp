#include "judge/explain/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace atelier::judge {
namespace {

constexpr double most = 0.7;    // the fraction for "most of them"
constexpr double nearly = 0.8;  // the fraction for a general statement: "are too bright"

/// The quantity in an output's pixels: "depth", "shadow factor".
std::string noun_of(const JudgedCase& c) {
  const std::string& output = c.ask.output;
  if (output == "uv" || output == "texcoord") return "texture coordinate";
  if (output == "shadow") return "shadow factor";
  if (output == "colour") return "value";
  return output;
}

/// The direction of the failing pixels' differences.
struct Tendency {
  std::array<double, 3> size{};         ///< mean absolute difference of red, green, blue
  std::array<double, 3> signed_size{};  ///< mean signed difference
  double up = 0, down = 0;  ///< fractions of the failing pixels whose sum of channels is too large, or too small
};

Tendency tendency_of(const Mask& over, const Image& yours, const Image& reference) {
  Tendency t;
  const double one = 1.0 / std::max(1, over.count());
  for (int y = 0; y < over.height(); ++y)
    for (int x = 0; x < over.width(); ++x) {
      if (!over.at(x, y)) continue;
      const Rgba &p = yours.at(x, y), &q = reference.at(x, y);
      const std::array<double, 3> d{double(p.r) - q.r, double(p.g) - q.g, double(p.b) - q.b};
      for (int channel = 0; channel < 3; ++channel) {
        t.size[channel] += one * std::abs(d[channel]);
        t.signed_size[channel] += one * d[channel];
      }
      const double sum = d[0] + d[1] + d[2];
      (sum > 0 ? t.up : t.down) += one;
    }
  return t;
}

/// "too bright", "too dark", "too red", "short of blue", or empty if there is no common direction.
std::string colour_direction(const Tendency& t) {
  constexpr std::array names{"red", "green", "blue"};
  for (int k = 0; k < 3; ++k) {
    const double others = std::max(t.size[(k + 1) % 3], t.size[(k + 2) % 3]);
    if (t.size[k] < 3 * others || std::abs(t.signed_size[k]) < nearly * t.size[k]) continue;
    return fmt::format("{} {}", t.signed_size[k] > 0 ? "too" : "short of", names[k]);
  }
  if (t.up >= nearly) return "too bright";
  if (t.down >= nearly) return "too dark";
  return "";
}

/// "37 % of the pixels", "12 of 65 536 pixels".
std::string how_many(const Measurement& measured) {
  if (measured.difference.share >= 0.01) return percent(measured.difference.share) + " of the pixels";
  return fmt::format("{} of {} pixels", grouped(measured.difference.over), grouped(measured.pixels));
}

/// "0.07 pixels to the right and 0.5 up".
std::string shift_words(const Shift& shift) {
  std::string text;
  const auto add = [&](double length, const char* positive, const char* negative) {
    if (std::abs(length) < 0.01) return;
    text += fmt::format("{}{:.2f} {}{}", text.empty() ? "" : " and ", std::abs(length), text.empty() ? "pixels " : "",
                        length > 0 ? positive : negative);
  };
  add(shift.x, "to the right", "to the left");
  add(shift.y, "down", "up");
  return text.empty() ? "a fraction of a pixel" : text;
}

std::string form_of(const Measurement& measured) {
  if (measured.difference.blob > 0)
    return measured.difference.share < 0.01 ? fmt::format(", as a solid patch near ({}, {})",
                                                          measured.difference.worst.x, measured.difference.worst.y)
                                            : "";
  return measured.difference.share < 0.05 ? ", as thin lines or single points" : "";
}

std::string colour_failure(const Measurement& measured, const Image& yours, const Image& reference,
                           const JudgedCase& c) {
  const std::string direction = colour_direction(tendency_of(measured.difference.mask, yours, reference));
  const std::string off = amount(measured.difference.worst_distance, c.unit);
  const bool one = measured.difference.over == 1;
  if (direction.empty())
    return fmt::format("{} {} a wrong colour, off by up to {}", how_many(measured), one ? "has" : "have", off);
  return fmt::format("{} {} {} by up to {}", how_many(measured), one ? "is" : "are", direction, off);
}

std::string data_failure(const Measurement& measured, const Image& yours, const Image& reference, const JudgedCase& c) {
  const std::string off = amount(measured.difference.worst_distance, c.unit);
  if (c.unit == Unit::degrees)
    return fmt::format("at {} the {} has a wrong direction, off by up to {}", how_many(measured), noun_of(c), off);
  const Tendency t = tendency_of(measured.difference.mask, yours, reference);
  return fmt::format("at {} the {} is {} by up to {}", how_many(measured), noun_of(c),
                     t.up >= nearly     ? "too large"
                     : t.down >= nearly ? "too small"
                                        : "off",
                     off);
}

std::string sentence(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text + ".";
}

}  // namespace

std::string percent(double fraction) {
  const double value = 100 * fraction;
  if (value <= 0) return "0 %";
  if (value < 0.01) return "under 0.01 %";
  return value < 0.995 ? fmt::format("{:.2g} %", value) : fmt::format("{:.0f} %", value);
}

std::string grouped(long long number) {
  std::string digits = std::to_string(std::llabs(number));
  for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), " ");
  return (number < 0 ? "-" : "") + digits;
}

std::string amount(double value, Unit unit) {
  if (is_colour(unit)) return fmt::format("{:.3g}/255", value);
  if (unit == Unit::degrees) return fmt::format("{:.3g} degrees", value);
  return fmt::format("{:.3g}", value);
}

std::string place_of(const Mask& over) {
  std::array<double, 3> rows{}, columns{};
  double all = 0, upper = 0, left = 0;
  for (int y = 0; y < over.height(); ++y)
    for (int x = 0; x < over.width(); ++x) {
      if (!over.at(x, y)) continue;
      ++all;
      rows[std::size_t(3 * y / over.height())] += 1;
      columns[std::size_t(3 * x / over.width())] += 1;
      upper += 2 * y < over.height();
      left += 2 * x < over.width();
    }
  if (all == 0 || over.width() < 3 || over.height() < 3) return "";
  if (all > 0.6 * over.width() * over.height()) return "all over the picture";

  const auto favoured = [&](const std::array<double, 3>& thirds) {
    const auto largest = std::max_element(thirds.begin(), thirds.end());
    return *largest >= most * all ? int(largest - thirds.begin()) : -1;
  };
  const int row = favoured(rows), column = favoured(columns);
  constexpr std::array<std::array<const char*, 3>, 3> cells{
      {{"in the upper left", "in the upper middle", "in the upper right"},
       {"on the left", "in the middle", "on the right"},
       {"in the lower left", "in the lower middle", "in the lower right"}}};
  constexpr std::array bands{"in the upper third", "across the middle", "in the lower third"};
  constexpr std::array strips{"in the left third", "from top to bottom in the middle", "in the right third"};
  std::string place;
  if (row >= 0 && column >= 0)
    place = cells[std::size_t(row)][std::size_t(column)];
  else if (row >= 0)
    place = bands[std::size_t(row)];
  else if (column >= 0)
    place = strips[std::size_t(column)];
  else if (upper >= most * all || upper <= (1 - most) * all)
    place = upper >= most * all ? "in the upper half" : "in the lower half";
  else if (left >= most * all || left <= (1 - most) * all)
    place = left >= most * all ? "in the left half" : "in the right half";
  return place.empty() || all < 2 ? place : "most of them " + place;
}

std::string describe_failure(const Measurement& measured, const Image& yours, const Image& reference,
                             const JudgedCase& c) {
  const Difference& found = measured.difference;
  const bool only_shifted = measured.shifted && found.blob == 0 && found.over <= effective_budget(c, measured.pixels);
  if (only_shifted)
    return sentence(fmt::format("Every pixel is within {}, but the whole picture is shifted by {}",
                                amount(c.delta, c.unit), shift_words(measured.shift)));
  std::string text =
      is_colour(c.unit) ? colour_failure(measured, yours, reference, c) : data_failure(measured, yours, reference, c);
  if (const std::string place = place_of(found.mask); !place.empty()) text += ", " + place;
  return sentence(text + form_of(measured));
}

std::string describe_pass(const Measurement& measured, const JudgedCase& c) {
  const Difference& found = measured.difference;
  if (found.worst_distance == 0) return "Every pixel is equal to the reference.";
  if (c.profile == Profile::exact) return "Every pixel is equal to the reference, level by level.";
  const std::string largest = amount(found.worst_distance, c.unit), delta = amount(c.delta, c.unit);
  if (c.profile == Profile::robust)
    return fmt::format("No solid area is outside the range of the reference's neighbourhood by more than {}.", delta);
  if (found.over == 0) return fmt::format("No pixel is off by more than {} ({} is allowed).", largest, delta);
  return fmt::format("{} of {} pixels are off by more than {} ({} may be).", grouped(found.over),
                     grouped(measured.pixels), delta, grouped(effective_budget(c, measured.pixels)));
}

std::string factor_name(double factor, double within) {
  using std::numbers::pi;
  constexpr std::array<std::pair<double, const char*>, 11> known{{{pi, "pi"},
                                                                  {1 / pi, "1/pi"},
                                                                  {2 * pi, "2 pi"},
                                                                  {1 / (2 * pi), "1/(2 pi)"},
                                                                  {4 * pi, "4 pi"},
                                                                  {1 / (4 * pi), "1/(4 pi)"},
                                                                  {180 / pi, "180/pi"},
                                                                  {pi / 180, "pi/180"},
                                                                  {2, "2"},
                                                                  {0.5, "1/2"},
                                                                  {1 / 3.0, "1/3"}}};
  for (const auto& [value, name] : known)
    if (std::abs(factor / value - 1) < within) return name;
  return "";
}

std::string colour_name(const Rgba& encoded) {
  const float low = std::min({encoded.r, encoded.g, encoded.b}), high = std::max({encoded.r, encoded.g, encoded.b});
  if (high < 0.02f) return "black";
  if (low > 0.98f) return "white";
  if (high - low < 0.05f) return high > 0.6f ? "light grey" : high > 0.3f ? "grey" : "dark grey";
  const auto on = [&](float v) { return v > (low + high) / 2 ? 1 : 0; };
  constexpr std::array names{"", "blue", "green", "cyan", "red", "magenta", "yellow", ""};
  const std::string hue = names[std::size_t(4 * on(encoded.r) + 2 * on(encoded.g) + on(encoded.b))];
  return high < 0.4f ? "dark " + hue : hue;
}

}  // namespace atelier::judge
