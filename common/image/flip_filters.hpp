// The filters of FLIP, and one dimension of filtering. All of them are Gaussians or derivatives of Gaussians, so each
// is a product of a filter along x and one along y, and each of these is even or odd: what lies k to the right of the
// centre weighs the same as what lies k to the left, up to the sign.
#pragma once

#include <vector>

namespace atelier::flip_detail {

/// One half of a filter of one dimension: weight[0] of the centre, weight[k] of the taps k away on the positive side.
/// On the negative side they weigh the same (even) or the opposite (odd).
struct Filter {
  std::vector<float> weight;
  bool odd = false;
  int radius() const { return int(weight.size()) - 1; }
};

/// What a viewer's contrast sensitivity leaves of each opponent channel (section 4.1.1 of the paper). The blue-yellow
/// channel's filter is a sum of two Gaussians: no product, but a sum of two.
struct ContrastFilters {
  Filter luminance, red_green, blue_yellow[2];
};
ContrastFilters contrast_filters(double pixels_per_degree);

/// Detectors of features as wide as what the eye resolves (section 4.2.1): along one axis a derivative, along the other
/// the Gaussian. Positive weights add up to 1, negative ones to -1.
struct FeatureFilters {
  Filter smooth, edge, point;
};
FeatureFilters feature_filters(double pixels_per_degree);

/// out[i] = (filter applied at i), with taps[k][i] the value at offset k - radius from i. Pointers into one row, each
/// one further, filter along x; pointers to as many rows filter along y.
void apply(const Filter& filter, const float* const* taps, int count, float* out);

}  // namespace atelier::flip_detail
