// The filters of FLIP and 1D filtering. All are Gaussians or derivatives of Gaussians, so each is separable into a
// filter along x and one along y, and each of these is even or odd: taps k to the left and to the right of the centre
// have the same weight, up to the sign.
#pragma once

#include <vector>

namespace atelier::flip_detail {

/// One half of a 1D filter: weight[0] for the centre, weight[k] for the tap at offset k. The tap at -k has the same
/// weight (even) or its negative (odd).
struct Filter {
  std::vector<float> weight;
  bool odd = false;
  int radius() const { return int(weight.size()) - 1; }
};

/// The contrast sensitivity filter of each opponent channel (section 4.1.1 of the paper). The filter of the blue-yellow
/// channel is a sum of two Gaussians: not separable, but a sum of two separable filters.
struct ContrastFilters {
  Filter luminance, red_green, blue_yellow[2];
};
ContrastFilters contrast_filters(double pixels_per_degree);

/// Feature detectors with the eye's resolution (section 4.2.1): a derivative along one axis, the Gaussian along the
/// other. Positive weights add up to 1, negative ones to -1.
struct FeatureFilters {
  Filter smooth, edge, point;
};
FeatureFilters feature_filters(double pixels_per_degree);

/// out[i] = (filter applied at i), with taps[k][i] the value at offset k - radius from i. Successive pointers into one
/// row filter along x; pointers to different rows filter along y.
void apply(const Filter& filter, const float* const* taps, int count, float* out);

}  // namespace atelier::flip_detail
