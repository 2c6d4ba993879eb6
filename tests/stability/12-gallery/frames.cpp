#include "stability/12-gallery/frames.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "12-gallery/gallery.hpp"

namespace atelier::stability {

namespace {

glm::dmat4 frame_at(const glm::dvec3& place, double sine, double cosine) {
  return {glm::dvec4(cosine, 0, -sine, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(sine, 0, cosine, 0),
          glm::dvec4(place, 1)};
}

}  // namespace

glm::dmat4 upright_frame(Trial& t, double distance) {
  const long double turn = t.between(0, 2 * std::numbers::pi);
  return frame_at(distance * t.direction(), double(std::sin(turn)), double(std::cos(turn)));
}

glm::dmat4 quarter_frame(Trial& t, double size) {
  const double sign = t.sign();
  const bool along_x = t.sign() > 0;
  return frame_at(dyadic_place(t, size), along_x ? sign : 0, along_x ? 0 : sign);
}

long double reach_along(const Exact& direction) {
  long double most = 0;
  for (const glm::dvec3& corner : gallery::corners_of({0, 0, 0}))
    most = std::max(most, glm::dot(direction, Exact(corner)));
  return most;
}

}  // namespace atelier::stability
