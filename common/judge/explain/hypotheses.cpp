#include "judge/explain/hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <utility>

#include "image/colour.hpp"
#include "image/compare.hpp"
#include "judge/compare/measure.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

/// How to undo an operation pixel by pixel: the undone picture is value(yours(source(x, y))).
struct Undo {
  Hypothesis hypothesis;
  std::function<glm::ivec2(glm::ivec2)> source;
  std::function<Rgba(const Rgba&)> value;
  double slack = 1;  ///< factor on delta, for operations that magnify small differences when undone
};

/// The delta for an undone picture. The exact profile requires equality, but rounding to 8 bits must not hide an
/// operation.
double undone_delta(const JudgedCase& c, double slack) {
  if (c.profile != Profile::exact) return c.delta * slack;
  return c.unit == Unit::number ? 0 : 0.5 * slack;
}

/// The pixels of the undone picture and of the reference at `positions`, one row each. If a source is outside the
/// picture, the reference's pixel is used, since the position tells nothing.
struct Undone {
  Image picture, reference;
};
Undone undo_at(const FailingPicture& failing, const Undo& undo, std::span<const Position> positions) {
  const int width = failing.reference.width(), height = failing.reference.height();
  Undone undone{Image(int(positions.size()), 1), Image(int(positions.size()), 1)};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto [x, y] = positions[i];
    const Rgba& expected = undone.reference.at(int(i), 0) = failing.reference.at(x, y);
    const glm::ivec2 at = undo.source ? undo.source({x, y}) : glm::ivec2(x, y);
    const bool inside = at.x >= 0 && at.y >= 0 && at.x < width && at.y < height;
    const Rgba& pixel = inside ? failing.yours.at(at.x, at.y) : expected;
    undone.picture.at(int(i), 0) = inside && undo.value ? undo.value(pixel) : pixel;
  }
  return undone;
}

int over_at(const FailingPicture& failing, const Undo& undo, std::span<const Position> positions) {
  const Undone undone = undo_at(failing, undo, positions);
  return compare_strict(undone.picture, undone.reference, measure_of(failing.c.unit),
                        undone_delta(failing.c, undo.slack))
      .over;
}

/// At most 512 failing pixels, evenly spread: enough to reject most operations quickly.
std::vector<Position> sample_of(const Mask& over) {
  std::vector<Position> all;
  for (int y = 0; y < over.height(); ++y)
    for (int x = 0; x < over.width(); ++x)
      if (over.at(x, y)) all.push_back({x, y});
  const std::size_t stride = all.size() / 512 + 1;
  std::vector<Position> sample;
  for (std::size_t i = 0; i < all.size(); i += stride) sample.push_back(all[i]);
  return sample;
}

/// The number of failing pixels after undoing, counted row by row until `limit` is reached.
int over_when_undone(const FailingPicture& failing, const Undo& undo, int limit) {
  std::vector<Position> row(std::size_t(failing.reference.width()));
  int over = 0;
  for (int y = 0; y < failing.reference.height() && over < limit; ++y) {
    for (int x = 0; x < int(row.size()); ++x) row[std::size_t(x)] = {x, y};
    over += over_at(failing, undo, row);
  }
  return over;
}

template <class Channel>
std::function<Rgba(const Rgba&)> per_channel(Channel channel) {
  return [channel](const Rgba& p) { return Rgba{channel(p.r), channel(p.g), channel(p.b), p.a}; };
}

void add_mirrors(std::vector<Undo>& undos, int width, int height) {
  const int right = width - 1, bottom = height - 1;
  undos.push_back(
      {{"flipped-y", "The picture is upside down: flipped vertically it matches.",
        "Row 0 is the top row, but gl_FragCoord and texture coordinates count from the bottom: check the sign of y, "
        "and v against 1 - v."},
       [=](glm::ivec2 p) { return glm::ivec2(p.x, bottom - p.y); }});
  undos.push_back({{"flipped-x", "The picture is mirrored left to right.",
                    "Check the sign of x: the order of a cross product, or the sign of the right vector."},
                   [=](glm::ivec2 p) { return glm::ivec2(right - p.x, p.y); }});
  undos.push_back({{"rotated-180", "The picture is rotated by 180 degrees.",
                    "Both x and y are negated: look for a sign that affects both, such as a negative w or scale."},
                   [=](glm::ivec2 p) { return glm::ivec2(right - p.x, bottom - p.y); }});
  if (width == height)
    undos.push_back({{"transposed", "Rows and columns are exchanged: mirrored at its diagonal the picture matches.",
                      "Look for x and y, or a row and a column index, in the wrong order."},
                     [](glm::ivec2 p) { return glm::ivec2(p.y, p.x); }});
}

void add_shifts(std::vector<Undo>& undos, int width, int height) {
  constexpr int min_side = 8;  // pixels; along a shorter side a shift by one pixel explains nothing
  for (int dy : {-1, 0, 1})
    for (int dx : {-1, 0, 1}) {
      if ((dx == 0 && dy == 0) || (dx != 0 && width < min_side) || (dy != 0 && height < min_side)) continue;
      const std::string sideways = dx == 0 ? "" : dx > 0 ? "to the right" : "to the left";
      const std::string along = dy == 0 ? "" : dy > 0 ? "down" : "up";
      undos.push_back(
          {{"shifted",
            fmt::format("The whole picture is shifted by one pixel {}{}{}.", sideways, dx && dy ? " and " : "", along),
            "Pixel centres lie at half-integer coordinates: look for a missing or extra 0.5, or an index that "
            "starts at 1."},
           [=](glm::ivec2 p) { return p + glm::ivec2(dx, dy); }});
    }
}

void add_channel_swaps(std::vector<Undo>& undos) {
  using Order = std::array<int, 3>;  // which channel of yours holds red, green, blue
  constexpr std::array<std::pair<Order, const char*>, 5> swaps{{{{2, 1, 0}, "red and blue"},
                                                                {{1, 0, 2}, "red and green"},
                                                                {{0, 2, 1}, "green and blue"},
                                                                {{1, 2, 0}, "red, green and blue in a cycle"},
                                                                {{2, 0, 1}, "red, green and blue in a cycle"}}};
  for (const auto& [order, words] : swaps)
    undos.push_back({{"swapped-channels", fmt::format("Channels are exchanged: {}.", words),
                      "Check the order of the components, and the format of the texture upload."},
                     {},
                     [order = order](const Rgba& p) {
                       const std::array channels{p.r, p.g, p.b};
                       return Rgba{channels[order[0]], channels[order[1]], channels[order[2]], p.a};
                     }});
}

void add_encodings(std::vector<Undo>& undos, Unit unit) {
  // Undoing the curve magnifies differences: its slope is 12.9 in the darkest range.
  constexpr double magnified = 4;
  const bool by_judge = unit == Unit::colour;
  undos.push_back({{"encoded-twice", "The picture is too pale: it is sRGB-encoded twice.",
                    by_judge ? "Write linear colours: the picture is encoded after your program."
                             : "Encode once, at the end; textures are decoded when they are sampled."},
                   {},
                   per_channel([](float v) { return srgb_decode(v); }),
                   magnified});
  undos.push_back({{"not-encoded",
                    by_judge ? "The picture is too dark: linear values were sRGB-decoded once too often."
                             : "The picture is too dark: it has linear values instead of sRGB-encoded ones.",
                    by_judge ? "Decode colour textures once; light and materials are already linear."
                             : "Apply the sRGB curve to the finished colour."},
                   {},
                   per_channel([](float v) { return srgb_encode(v); }),
                   magnified});
}

void add_directions(std::vector<Undo>& undos) {
  const auto negate = [&](const char* name, const char* words, bool x, bool y, bool z) {
    undos.push_back({{name, fmt::format("The directions are right except for a sign: {} negated.", words),
                      "Check the order of the factors of a cross product, and the order of each difference of points."},
                     {},
                     [=](const Rgba& p) {
                       return Rgba{x ? 1 - p.r : p.r, y ? 1 - p.g : p.g, z ? 1 - p.b : p.b, p.a};
                     }});
  };
  negate("negated", "all three components are", true, true, true);
  negate("negated-x", "x is", true, false, false);
  negate("negated-y", "y (green) is", false, true, false);
  negate("negated-z", "z is", false, false, true);
  undos.push_back({{"not-packed", "The directions are written as n instead of n/2 + 1/2.",
                    "The components of a direction are in -1..1, but colours are in 0..1: write n * 0.5 + 0.5."},
                   {},
                   per_channel([](float v) { return 0.5f * v + 0.5f; })});
  undos.push_back({{"packed-twice", "The directions are packed twice: n/2 + 1/2 was applied to n/2 + 1/2.",
                    "Unpack what you read (2c - 1) before you compute with it, and pack once when you write."},
                   {},
                   per_channel([](float v) { return 2 * v - 1; })});
}

void add_data(std::vector<Undo>& undos) {
  undos.push_back({{"complement", "The values are 1 - v instead of v.",
                    "Which end is 0? The contract says it: near or far, lit or in shadow, top or bottom."},
                   {},
                   per_channel([](float v) { return 1 - v; })});
  undos.push_back({{"signed-range", "The values are in -1..1 instead of 0..1.",
                    "Map clip space to textures and depth by v * 0.5 + 0.5."},
                   {},
                   per_channel([](float v) { return 0.5f * v + 0.5f; })});
  undos.push_back({{"halved-range", "The values are v/2 + 1/2 instead of v.",
                    "The mapping from -1..1 to 0..1 was applied to a value that is already in 0..1."},
                   {},
                   per_channel([](float v) { return 2 * v - 1; }),
                   2});  // undoing doubles differences
}

std::vector<Undo> undos_for(const FailingPicture& failing) {
  std::vector<Undo> undos;
  add_mirrors(undos, failing.reference.width(), failing.reference.height());
  add_shifts(undos, failing.reference.width(), failing.reference.height());
  switch (failing.c.unit) {
    case Unit::colour:
    case Unit::encoded:
      add_channel_swaps(undos);
      add_encodings(undos, failing.c.unit);
      break;
    case Unit::degrees:
      add_channel_swaps(undos);
      add_directions(undos);
      break;
    case Unit::number:
      add_data(undos);
      break;
  }
  return undos;
}

/// The median of yours / reference over the pixels whose reference is not nearly zero; 1 if there are none.
double median_ratio(const Image& yours, const Image& reference) {
  const auto size = [](const Rgba& p) { return double(p.r) + p.g + p.b; };
  double brightest = 0;
  for (const Rgba& pixel : reference.pixels()) brightest = std::max(brightest, std::abs(size(pixel)));
  std::vector<double> ratios;
  for (std::size_t i = 0; i < reference.pixels().size(); ++i) {
    const double expected = size(reference.pixels()[i]);
    if (std::abs(expected) > 0.02 * brightest) ratios.push_back(size(yours.pixels()[i]) / expected);
  }
  if (ratios.empty()) return 1;
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

/// " (that is pi)" for a factor within half a percent of a known one.
std::string name_of_factor(double gain) {
  const std::string name = factor_name(gain, 0.005);
  return name.empty() ? "" : fmt::format(" (that is {})", name);
}

/// A constant factor on the light, or on the data.
std::optional<Hypothesis> explain_by_gain(const FailingPicture& failing, int limit) {
  if (failing.c.unit == Unit::degrees) return std::nullopt;
  const double gain = median_ratio(failing.yours_raw, failing.reference_raw);
  // A factor nearer to 1 is hardly a forgotten one; for a more extreme one a few noisy pixels would decide.
  if (!(gain > 1 / 20.0 && gain < 20) || std::abs(gain - 1) < 0.02) return std::nullopt;

  Image scaled = failing.yours_raw;
  for (Rgba& p : scaled.pixels()) p = {float(p.r / gain), float(p.g / gain), float(p.b / gain), p.a};
  const Image undone = compared_form(scaled, failing.c);
  const FailingPicture rest{scaled, failing.reference_raw, undone, failing.reference, failing.c, failing.over};
  Undo identity;
  identity.slack = std::max(1.0, 1 / gain);  // making a dark picture brighter magnifies its differences
  Hypothesis hypothesis;
  hypothesis.name = "gain";
  hypothesis.over = over_when_undone(rest, identity, limit);
  if (hypothesis.over >= limit) return std::nullopt;

  const std::string factor = fmt::format("{:.3g} times", gain > 1 ? gain : 1 / gain);
  const bool data = failing.c.unit == Unit::number;
  hypothesis.sentence = data ? fmt::format("All values are {:.3g} times the right ones{}.", gain, name_of_factor(gain))
                             : fmt::format("Everything is {} too {}{}, but otherwise right.", factor,
                                           gain > 1 ? "bright" : "dark", name_of_factor(gain));
  hypothesis.hint = data ? "A unit or a range is wrong by a constant factor."
                         : "Look for a constant that is missing or applied twice: 1/pi, an intensity, a weight.";
  return hypothesis;
}

}  // namespace

std::optional<Hypothesis> explain_whole_picture(const FailingPicture& failing) {
  const std::vector<Position> sample = sample_of(failing.over);
  if (sample.empty()) return std::nullopt;
  const int over = failing.over.count();
  // Fewer than `limit` pixels may still fail; if no more fail than the budget allows, none may.
  int limit = over <= failing.c.budget ? 1 : int(max_unexplained_fraction * over) + 1;
  std::optional<Hypothesis> best;
  for (Undo& undo : undos_for(failing)) {
    if (over_at(failing, undo, sample) > 2 * max_unexplained_fraction * double(sample.size())) continue;
    const int left = over_when_undone(failing, undo, limit);
    if (left >= limit) continue;
    best = std::move(undo.hypothesis);
    best->over = limit = left;
    if (left == 0) return best;
  }
  if (auto gain = explain_by_gain(failing, limit)) return gain;
  return best;
}

}  // namespace atelier::judge
