#include "image/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace atelier::flip_detail {
namespace {

/// Taps below this fraction of the centre's weight do not change a float result: they are left out.
constexpr double negligible = 1e-8;

double gaussian(double x, double deviation) {
  return std::exp(-x * x / (2 * deviation * deviation));
}

/// Over all taps of an even filter: the centre once, the others twice.
double sum(const std::vector<double>& half) {
  double total = -half[0];
  for (double weight : half) total += 2 * weight;
  return total;
}

Filter make_filter(const std::vector<double>& half, double scale, bool odd = false) {
  double largest = 0;
  for (double weight : half) largest = std::max(largest, std::abs(weight));
  std::size_t used = half.size();
  while (used > 1 && std::abs(half[used - 1]) < negligible * largest) --used;
  Filter filter{std::vector<float>(used), odd};
  for (std::size_t k = 0; k < used; ++k) filter.weight[k] = float(half[k] * scale);
  return filter;
}

std::vector<double> sample_gaussian(double deviation, int radius) {
  std::vector<double> half(std::size_t(radius) + 1);
  for (int k = 0; k <= radius; ++k) half[std::size_t(k)] = gaussian(k, deviation);
  return half;
}

/// `Taps` pairs of taps at once, so that the running sum is read and written once for all of them.
template <int Taps>
void add_pairs(const float* weight, const float* const* lower, const float* const* upper, float sign, int count,
               float* __restrict out) {
  const float *low[Taps], *high[Taps];
  float w[Taps];
  for (int t = 0; t < Taps; ++t) low[t] = lower[-t], high[t] = upper[t], w[t] = weight[t];
  for (int i = 0; i < count; ++i) {
    float total = out[i];
#pragma GCC unroll 8
    for (int t = 0; t < Taps; ++t) total += w[t] * (high[t][i] + sign * low[t][i]);
    out[i] = total;
  }
}

}  // namespace

ContrastFilters contrast_filters(double pixels_per_degree) {
  // exp(-pi^2 d^2 / b), d in degrees, is a Gaussian with this deviation in pixels.
  const auto deviation = [&](double b) { return std::sqrt(b / 2) / std::numbers::pi * pixels_per_degree; };
  constexpr double b_luminance = 0.0047, b_red_green = 0.0053, b_wide = 0.04, b_narrow = 0.025;
  const int radius = int(std::ceil(3 * deviation(b_wide)));

  const auto single = [&](double b) {
    const auto half = sample_gaussian(deviation(b), radius);
    return make_filter(half, 1 / sum(half));
  };
  // In two dimensions a filter weighs a sqrt(pi / b) times its separable Gaussian; half of that factor goes to each
  // axis.
  const auto wide = sample_gaussian(deviation(b_wide), radius), narrow = sample_gaussian(deviation(b_narrow), radius);
  const double factor_wide = 34.1 * std::sqrt(std::numbers::pi / b_wide),
               factor_narrow = 13.5 * std::sqrt(std::numbers::pi / b_narrow),
               total = factor_wide * sum(wide) * sum(wide) + factor_narrow * sum(narrow) * sum(narrow);
  return {single(b_luminance),
          single(b_red_green),
          {make_filter(wide, std::sqrt(factor_wide / total)), make_filter(narrow, std::sqrt(factor_narrow / total))}};
}

FeatureFilters feature_filters(double pixels_per_degree) {
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int radius = int(std::ceil(3 * deviation));
  const std::vector<double> smooth = sample_gaussian(deviation, radius);
  std::vector<double> edge = smooth, point = smooth;
  double edge_sum = 0, positive = 0, negative = 0;
  for (int k = 0; k <= radius; ++k) {
    double &slope = edge[std::size_t(k)], &curvature = point[std::size_t(k)];
    slope *= -k;
    curvature *= k * k / (deviation * deviation) - 1;
    edge_sum -= slope;
    (curvature > 0 ? positive : negative) += (k == 0 ? 1 : 2) * std::abs(curvature);
  }
  for (double& weight : point) weight /= weight > 0 ? positive : negative;
  return {make_filter(smooth, 1 / sum(smooth)), make_filter(edge, 1 / edge_sum, true), make_filter(point, 1)};
}

void apply(const Filter& filter, const float* const* taps, int count, float* __restrict out) {
  const int radius = filter.radius();
  const float centre = filter.weight[0], sign = filter.odd ? -1.0f : 1.0f;
  const float* middle = taps[radius];
  for (int i = 0; i < count; ++i) out[i] = centre * middle[i];
  int k = 1;
  for (; k + 3 <= radius; k += 4)
    add_pairs<4>(&filter.weight[std::size_t(k)], taps + radius - k, taps + radius + k, sign, count, out);
  for (; k <= radius; ++k)
    add_pairs<1>(&filter.weight[std::size_t(k)], taps + radius - k, taps + radius + k, sign, count, out);
}

}  // namespace atelier::flip_detail
