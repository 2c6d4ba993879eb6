#include "judge/explain/naming.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "judge/compare/probe.hpp"

namespace atelier::judge {
namespace {

/// Smaller differences are ignored: half a level for the 8 bits of the atlas, and one level for other processors.
constexpr float dead_zone = 1.5f / 255;

struct Range {
  float low = 0, high = 1;
};

float channel_of(const Rgba& pixel, int channel) {
  return channel == 0 ? pixel.r : channel == 1 ? pixel.g : pixel.b;
}

/// The range that the atlas maps to 0..1: the reference's, extended by half on both sides for the values of mistakes.
Range range_of(const Image& reference, int channel) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const Rgba& pixel : reference.pixels()) {
    low = std::min(low, channel_of(pixel, channel));
    high = std::max(high, channel_of(pixel, channel));
  }
  // A nearly constant channel still needs a range: a tenth of its values.
  const float spread = std::max({high - low, 0.1f * std::max(std::abs(low), std::abs(high)), 1e-3f});
  return {low - spread / 2, high + spread / 2};
}

// --- The effect of a mistake on pixels of a given value ---

constexpr int value_bins = 8;  ///< bins of the right picture's values: few, so that each has many pixels
constexpr int steps = 255;     ///< bins of the difference wrong - right, -1..1

/// For each channel and value of the right picture, a histogram of the wrong picture's difference.
struct Effect {
  std::array<std::array<std::array<double, steps>, value_bins>, 3> fraction{};  ///< of all pixels
  std::array<std::array<double, value_bins>, 3> weight{};                       ///< sum over the steps
};

int bin_of(float value, int bins) {
  return std::clamp(int(value * float(bins)), 0, bins - 1);
}

Effect effect_of(const Image& right, const Image& wrong) {
  Effect effect;
  const double one = 1.0 / double(right.pixels().size());
  for (std::size_t i = 0; i < right.pixels().size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const float expected = channel_of(right.pixels()[i], channel), shown = channel_of(wrong.pixels()[i], channel);
      const int value = bin_of(expected, value_bins);
      effect.fraction[channel][value][bin_of(0.5f + 0.5f * (shown - expected), steps)] += one;
      effect.weight[channel][value] += one;
    }
  return effect;
}

/// First Wasserstein distance of two histograms: the area between their cumulative sums.
double wasserstein(const std::array<double, steps>& a, double weight_a, const std::array<double, steps>& b,
                   double weight_b) {
  double sum_a = 0, sum_b = 0, area = 0;
  for (int step = 0; step < steps; ++step) {
    sum_a += a[step] / weight_a;
    sum_b += b[step] / weight_b;
    area += std::abs(sum_a - sum_b) / steps;
  }
  return area;
}

double distance_of(const Effect& a, const Effect& b) {
  double sum = 0, weight = 0;
  for (int channel = 0; channel < 3; ++channel)
    for (int value = 0; value < value_bins; ++value) {
      // Skip values that only one of the two views contains.
      const double common = std::min(a.weight[channel][value], b.weight[channel][value]);
      if (common <= 0) continue;
      sum += common * wasserstein(a.fraction[channel][value], a.weight[channel][value], b.fraction[channel][value],
                                  b.weight[channel][value]);
      weight += common;
    }
  return weight > 0 ? sum / weight : 1;
}

Candidate candidate(const Image& yours, const Image& reference, const AtlasPicture& entry) {
  if (entry.same_view && entry.picture.same_size(yours))
    return {entry.mistake, overlaid_distance(yours, entry.picture), overlaid_distance(yours, reference), true};
  const Effect effect = effect_of(reference, yours);
  return {entry.mistake, distance_of(effect, effect_of(entry.reference, entry.picture)),
          distance_of(effect, effect_of(reference, reference)), false};
}

/// 0 if equal to the mistake, 1 or more if the reference is at least as near.
double nearness(const Candidate& c) {
  return c.reference > 0 ? c.distance / c.reference : 1;
}

}  // namespace

Image make_atlas_picture(const Image& compared, const Image& reference_compared, Unit unit) {
  std::array<Range, 3> range;
  if (unit == Unit::number)
    for (int channel = 0; channel < 3; ++channel) range[channel] = range_of(reference_compared, channel);
  const auto mapped = [&](const Rgba& pixel, int channel) {
    const auto [low, high] = range[channel];
    return std::clamp((channel_of(pixel, channel) - low) / (high - low), 0.0f, 1.0f);
  };

  const int width = (compared.width() + 1) / 2, height = (compared.height() + 1) / 2;
  Image half(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<float, 3> sum{};
      int count = 0;  // fewer than four at the border of an odd size
      for (int sy = 2 * y; sy < std::min(2 * y + 2, compared.height()); ++sy)
        for (int sx = 2 * x; sx < std::min(2 * x + 2, compared.width()); ++sx, ++count)
          for (int channel = 0; channel < 3; ++channel) sum[channel] += mapped(compared.at(sx, sy), channel);
      half.at(x, y) = {sum[0] / float(count), sum[1] / float(count), sum[2] / float(count), 1};
    }
  return half;
}

double overlaid_distance(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    const float apart = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    sum += std::max(0.0f, apart - dead_zone);
  }
  return sum / double(a.pixels().size());
}

double effect_distance(const Image& right_a, const Image& wrong_a, const Image& right_b, const Image& wrong_b) {
  return distance_of(effect_of(right_a, wrong_a), effect_of(right_b, wrong_b));
}

std::vector<Candidate> rank_mistakes(const Image& yours, const Image& reference,
                                     const std::vector<AtlasPicture>& atlas) {
  std::vector<Candidate> ranked;
  for (const AtlasPicture& entry : atlas) ranked.push_back(candidate(yours, reference, entry));
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Candidate& a, const Candidate& b) { return nearness(a) < nearness(b); });
  return ranked;
}

std::optional<Candidate> recognise(const std::vector<Candidate>& ranked) {
  if (ranked.empty()) return std::nullopt;
  const double allowed = ranked[0].same_view ? max_nearness : max_nearness_other_view;
  if (nearness(ranked[0]) > allowed) return std::nullopt;
  if (ranked.size() > 1) {
    const double second = nearness(ranked[1]);
    if (second < min_second_nearness || nearness(ranked[0]) > max_ratio_to_second * second) return std::nullopt;
  }
  return ranked[0];
}

std::vector<std::string> recognise_values(const std::vector<Numbers>& yours,
                                          const std::map<std::string, std::vector<Numbers>>& wrong_values,
                                          const JudgedCase& c) {
  std::vector<std::string> found;
  for (const auto& [form, values] : wrong_values)
    if (!values.empty() && measure_probe(yours, values, c).passed) found.push_back(form);
  return found;
}

}  // namespace atelier::judge
