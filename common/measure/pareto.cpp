#include "measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace atelier::measure {

std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::erase_if(order, [&](std::size_t i) { return !std::isfinite(points[i].x) || !std::isfinite(points[i].y); });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
  });
  // In order of cost, a point is on the front only if its error is below all errors before it.
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].y < points[front.back()].y) front.push_back(i);
  return front;
}

std::optional<std::size_t> knee(std::span<const glm::dvec2> front) {
  if (front.empty()) return std::nullopt;
  double least = 0;
  for (const glm::dvec2& p : front)
    if (p.y > 0 && (least == 0 || p.y < least)) least = p.y;
  const auto logs = [&](const glm::dvec2& p) {
    return glm::dvec2(std::log(p.x), std::log(p.y > 0 ? p.y : least > 0 ? least / 10 : 1));
  };
  const glm::dvec2 first = logs(front.front()), last = logs(front.back());
  const glm::dvec2 span(last.x - first.x, first.y - last.y);  // not negative: cost rises along a front, error falls
  std::size_t farthest = 0;
  double most = -1;
  for (std::size_t i = 0; i < front.size(); ++i) {
    const glm::dvec2 p = logs(front[i]);
    const double along = span.x > 0 ? (p.x - first.x) / span.x : 0, down = span.y > 0 ? (first.y - p.y) / span.y : 0;
    if (down - along > most) most = down - along, farthest = i;
  }
  return farthest;
}

}  // namespace atelier::measure
