// The middle of measured values, and their range.
#pragma once

#include <algorithm>
#include <vector>

namespace atelier::measure {

/// Of at least one value; of an even number the mean of the two in the middle.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

struct Spread {
  double median = 1, least = 1, most = 1;
};

/// Of at least one value.
inline Spread spread_of(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax_element(values);
  return {median(values), *least, *most};
}

}  // namespace atelier::measure
