#include "stability/12-gallery/frames.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "12-gallery/gallery.hpp"

namespace atelier::stability {

namespace {

/// A multiple of 1/1024 between -size and size.
double dyadic(Trial& t, double size) {
  return std::floor(t.between(-size, size) * 1024) / 1024;
}

glm::dmat4 frame_at(const glm::dvec3& place, double sine, double cosine) {
  return {glm::dvec4(cosine, 0, -sine, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(sine, 0, cosine, 0),
          glm::dvec4(place, 1)};
}

}  // namespace

double largest_of(const Exact& v) {
  return double(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

glm::dmat4 upright_frame(Trial& t, double distance) {
  const long double turn = t.between(0, 2 * std::numbers::pi);
  return frame_at(distance * t.direction(), double(std::sin(turn)), double(std::cos(turn)));
}

glm::dvec3 dyadic_place(Trial& t, double size) {
  const double x = dyadic(t, size), y = dyadic(t, size);
  return {x, y, dyadic(t, size)};
}

glm::dmat4 quarter_frame(Trial& t, double size) {
  const double sign = t.sign();
  const bool along_x = t.sign() > 0;
  return frame_at(dyadic_place(t, size), along_x ? sign : 0, along_x ? 0 : sign);
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

Exact through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& p) {
  const Exact local = within(entry, p);
  return at(exit, {-local.x, local.y, -local.z});
}

long double reach_along(const Exact& direction) {
  long double most = 0;
  for (const glm::dvec3& corner : gallery::corners_of({0, 0, 0}))
    most = std::max(most, glm::dot(direction, Exact(corner)));
  return most;
}

}  // namespace atelier::stability
