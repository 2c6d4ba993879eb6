// A bounding volume hierarchy: a ray that misses a box misses everything in it.
//
// Built top-down with the surface area heuristic: the cost of a split is the expected number of primitives that a
// random ray tests, where the probability of hitting a box is proportional to its area. Splits between 16 bins along
// the longest axis are compared (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).
// Traversed without recursion, the nearer half first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

class Bvh {
 public:
  Bvh() = default;
  /// Over primitives with these bounding boxes; a primitive is identified by the index of its box.
  explicit Bvh(std::span<const Box3> boxes);

  /// Calls meet(i) for each primitive whose box the ray may hit, roughly from near to far, at most once each. `most` is
  /// the end of the ray's interval: `meet` may reduce it after a hit, and boxes beyond it are skipped. Stops if meet
  /// returns true.
  template <class Meet>
  void traverse(const Ray& ray, const double& most, Meet&& meet) const;

  /// Calls meet(i) for each primitive of a leaf unless misses(box) is true for a box around it.
  template <class Misses, class Meet>
  void visit(Misses&& misses, Meet&& meet) const;

  bool empty() const { return nodes_.empty(); }
  int depth() const { return depth_; }  ///< levels of boxes; 0 if empty

 private:
  struct Node {
    Box3 box;
    std::uint32_t begin = 0, end = 0;  ///< leaf: its range in order_; inner node: begin = end
    std::uint32_t second = 0;          ///< inner node: index of the second child; the first child is the next node
    int axis = 0;                      ///< inner node: the axis of its split
    bool leaf() const { return begin != end; }
  };
  /// Precomputed for the box tests: 1/direction, and per axis whether the ray runs backwards or parallel to its planes.
  struct Slopes {
    glm::dvec3 inverse;
    bool backwards[3], parallel[3];
    explicit Slopes(const glm::dvec3& direction);
  };

  struct Builder;
  static constexpr int deepest = 96;
  static bool meets(const Box3& box, const Ray& ray, const Slopes& slopes, double most);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  int depth_ = 0;
};

// ---- Templates, and what is called for every box

inline bool Bvh::meets(const Box3& box, const Ray& ray, const Slopes& slopes, double most) {
  double enter = ray.least, leave = most;
  for (int axis = 0; axis < 3; ++axis) {
    if (slopes.parallel[axis]) {  // avoids 0 times infinity, which is NaN
      if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return false;
      continue;
    }
    double in = (box.low[axis] - ray.origin[axis]) * slopes.inverse[axis],
           out = (box.high[axis] - ray.origin[axis]) * slopes.inverse[axis];
    if (slopes.backwards[axis]) std::swap(in, out);
    // Rounding may put the exit before the entry of a box that the ray touches: move the exit slightly. Ize, "Robust
    // BVH Ray Traversal", JCGT 2 (2013): by two parts in 2^52 of three roundings each.
    out += std::abs(out) * (6 * std::numeric_limits<double>::epsilon());
    enter = in > enter ? in : enter;
    leave = out < leave ? out : leave;
  }
  return enter <= leave;
}

template <class Meet>
void Bvh::traverse(const Ray& ray, const double& most, Meet&& meet) const {
  if (nodes_.empty()) return;
  const Slopes slopes(ray.direction);
  std::uint32_t waiting[deepest];
  int count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (!meets(node.box, ray, slopes, most)) continue;
    if (node.leaf()) {
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (meet(order_[i])) return;
    } else {
      const bool swapped = slopes.backwards[node.axis];
      waiting[count++] = swapped ? index + 1 : node.second;
      waiting[count++] = swapped ? node.second : index + 1;
    }
  }
}

template <class Misses, class Meet>
void Bvh::visit(Misses&& misses, Meet&& meet) const {
  if (nodes_.empty()) return;
  std::uint32_t waiting[deepest];
  int count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (misses(node.box)) continue;
    if (node.leaf()) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) meet(order_[i]);
    } else {
      waiting[count++] = node.second;
      waiting[count++] = index + 1;
    }
  }
}

}  // namespace atelier::oracle
