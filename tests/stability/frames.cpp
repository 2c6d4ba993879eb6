#include "stability/frames.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::stability {

Bound metres(double size, const char* reason) {
  return {16 * double_unit * size, "m", reason};
}

double largest_of(const Exact& v) {
  return double(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

glm::dvec3 dyadic_place(Trial& t, double size) {
  const auto dyadic = [&] { return std::floor(t.between(-size, size) * 1024) / 1024; };
  const double x = dyadic(), y = dyadic();
  return {x, y, dyadic()};
}

Exact axis(const glm::dmat4& frame, int i) {
  return Exact(glm::dvec3(frame[i]));
}
Exact origin(const glm::dmat4& frame) {
  return Exact(glm::dvec3(frame[3]));
}
Exact at(const glm::dmat4& frame, const Exact& local) {
  return origin(frame) + local.x * axis(frame, 0) + local.y * axis(frame, 1) + local.z * axis(frame, 2);
}
Exact within(const glm::dmat4& frame, const Exact& p) {
  const Exact from = p - origin(frame);
  return {glm::dot(axis(frame, 0), from), glm::dot(axis(frame, 1), from), glm::dot(axis(frame, 2), from)};
}

Exact turned_through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& direction) {
  return -glm::dot(axis(entry, 0), direction) * axis(exit, 0) + glm::dot(axis(entry, 1), direction) * axis(exit, 1) -
         glm::dot(axis(entry, 2), direction) * axis(exit, 2);
}
Exact through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& p) {
  return origin(exit) + turned_through(entry, exit, p - origin(entry));
}

}  // namespace atelier::stability
