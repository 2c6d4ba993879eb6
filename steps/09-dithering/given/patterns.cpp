#include "09-dithering/given/patterns.hpp"

#include <algorithm>

#include "base/shuffle.hpp"

namespace atelier {

std::vector<int> first_points(int size) {
  const std::vector<std::size_t> order = shuffled_order(std::size_t(size) * std::size_t(size), 1993);
  return {order.begin(), order.begin() + std::ptrdiff_t(std::max<std::size_t>(1, order.size() / 10))};
}

}  // namespace atelier
