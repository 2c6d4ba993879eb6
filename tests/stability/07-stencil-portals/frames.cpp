#include "stability/07-stencil-portals/frames.hpp"

#include <cmath>
#include <numbers>

namespace atelier::stability {

glm::dmat4 odd_frame(Trial& t, double distance) {
  const Exact z = glm::normalize(Exact(t.direction()));
  Exact other(0);
  other[std::abs(z.x) < 0.6L ? 0 : 1] = 1;
  const Exact u = glm::normalize(glm::cross(other, z)), v = glm::cross(z, u);
  const double angle = t.between(0, 2 * std::numbers::pi);
  const long double c = std::cos(static_cast<long double>(angle)), s = std::sin(static_cast<long double>(angle));
  const Exact x = c * u + s * v, y = c * v - s * u;
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(distance * t.direction(), 1)};
}

glm::dmat4 quarter_frame(Trial& t, double size) {
  const int first = int(t.between(0, 3)), second = (first + (t.sign() > 0 ? 1 : 2)) % 3;
  glm::dvec3 x(0), y(0);
  x[first] = t.sign();
  y[second] = t.sign();
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(glm::cross(x, y), 0), glm::dvec4(dyadic_place(t, size), 1)};
}

long double height_above(const glm::dmat4& frame, const Exact& p) {
  return glm::dot(axis(frame, 2), p - origin(frame));
}

Exact reflected(const glm::dmat4& mirror, const Exact& p) {
  return p - 2 * height_above(mirror, p) * axis(mirror, 2);
}

Exact mapped(const glm::dmat4& passage, const glm::dvec3& p) {
  return Exact(glm::dvec3(passage * glm::dvec4(p, 1)));
}

double determinant_of(const glm::dmat4& m) {
  return double(glm::dot(axis(m, 0), glm::cross(axis(m, 1), axis(m, 2))));
}

glm::mat4 view_of(const glm::dmat4& camera) {
  glm::mat4 view(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) view[column][row] = float(camera[row][column]);
    view[3][row] = float(-glm::dot(axis(camera, row), origin(camera)));
  }
  return view;
}

}  // namespace atelier::stability
