#include "oracle/bvh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier::oracle {

namespace {

constexpr int bins = 16;                ///< one more than the splits that are compared
constexpr std::uint32_t leaf_size = 4;  ///< nodes with at most this many primitives are leaves
constexpr int careful_depth = 56;       ///< below it nodes are split by count, which ends after 32 more levels

double half_area(const Box3& box) {
  if (box.empty()) return 0;
  const glm::dvec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

glm::dvec3 middle(const Box3& box) {
  return box.low * 0.5 + box.high * 0.5;
}

/// The bin of a position along an axis that runs from `low` over `length`.
int bin_of(double position, double low, double length) {
  return std::clamp(int((position - low) / length * bins), 0, bins - 1);
}

struct Cut {
  int bin = 0;  ///< primitives in bins below it go to the first half
  double cost = 0;
};

/// The split with the least sum of primitives x area.
Cut best_cut(const std::array<Box3, bins>& boxes, const std::array<std::uint32_t, bins>& counts) {
  std::array<double, bins> cost_behind{};
  Box3 box;
  std::uint32_t count = 0;
  for (int bin = bins - 1; bin > 0; --bin) {
    box.add(boxes[std::size_t(bin)]);
    count += counts[std::size_t(bin)];
    cost_behind[std::size_t(bin)] = count * half_area(box);
  }
  box = {};
  count = 0;
  Cut best{.cost = std::numeric_limits<double>::infinity()};
  for (int bin = 1; bin < bins; ++bin) {
    box.add(boxes[std::size_t(bin - 1)]);
    count += counts[std::size_t(bin - 1)];
    const double cost = count * half_area(box) + cost_behind[std::size_t(bin)];
    if (cost < best.cost) best = {bin, cost};
  }
  return best;
}

}  // namespace

Bvh::Slopes::Slopes(const glm::dvec3& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis];
    parallel[axis] = std::abs(d) < 1e-300;
    inverse[axis] = 1 / d;
    backwards[axis] = d < 0;
  }
}

struct Bvh::Builder {
  Bvh& tree;
  std::span<const Box3> boxes;

  /// Partitions the primitives begin..end; returns the start of the second half.
  std::uint32_t split(std::uint32_t begin, std::uint32_t end, int axis, const Box3& middles, bool by_number) {
    const auto first = tree.order_.begin() + begin, last = tree.order_.begin() + end;
    const double low = middles.low[axis], length = middles.high[axis] - low;
    if (!by_number && length > 0) {
      std::array<Box3, bins> bin_boxes;
      std::array<std::uint32_t, bins> counts{};
      const auto bin = [&](std::uint32_t thing) { return bin_of(middle(boxes[thing])[axis], low, length); };
      for (auto thing = first; thing != last; ++thing) {
        bin_boxes[std::size_t(bin(*thing))].add(boxes[*thing]);
        ++counts[std::size_t(bin(*thing))];
      }
      const Cut cut = best_cut(bin_boxes, counts);
      const auto at = std::stable_partition(first, last, [&](std::uint32_t thing) { return bin(thing) < cut.bin; });
      if (at != first && at != last) return std::uint32_t(at - tree.order_.begin());
    }
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(first, tree.order_.begin() + half, last, [&](std::uint32_t a, std::uint32_t b) {
      const double left = middle(boxes[a])[axis], right = middle(boxes[b])[axis];
      return left != right ? left < right : a < b;
    });
    return half;
  }

  void build(std::uint32_t begin, std::uint32_t end, int depth) {
    tree.depth_ = std::max(tree.depth_, depth);
    Box3 box, middles;
    for (std::uint32_t i = begin; i < end; ++i) {
      box.add(boxes[tree.order_[i]]);
      middles.add(middle(boxes[tree.order_[i]]));
    }
    const std::size_t index = tree.nodes_.size();
    tree.nodes_.push_back({.box = box, .begin = begin, .end = end});
    if (end - begin <= leaf_size) return;

    const glm::dvec3 size = middles.high - middles.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    // With zero area all splits have the same cost.
    const bool by_number = depth > careful_depth || half_area(box) == 0;
    const std::uint32_t half = split(begin, end, axis, middles, by_number);
    build(begin, half, depth + 1);
    const auto second = std::uint32_t(tree.nodes_.size());
    build(half, end, depth + 1);
    Node& node = tree.nodes_[index];
    node.begin = node.end = 0;
    node.second = second;
    node.axis = axis;
  }
};

Bvh::Bvh(std::span<const Box3> boxes) {
  order_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) order_[i] = std::uint32_t(i);
  nodes_.reserve(boxes.size());
  if (!boxes.empty()) Builder{*this, boxes}.build(0, std::uint32_t(boxes.size()), 1);
}

}  // namespace atelier::oracle
