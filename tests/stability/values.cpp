#include "stability/values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stability/extremes.hpp"

namespace atelier::stability {

namespace {

/// The largest of distance(actual, expected); infinite where one is NaN or a number has no partner.
template <class Distance>
double largest(const Values& actual, const Values& expected, Distance distance) {
  if (actual.size() != expected.size()) return double(infinite);
  double worst = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double here = actual[i] == expected[i] ? 0 : distance(actual[i], expected[i]);  // infinities may be equal
    if (std::isnan(here)) return double(infinite);
    worst = std::max(worst, here);
  }
  return worst;
}

}  // namespace

double count_outside(const Values& values, double low, double high) {
  return double(std::count_if(values.begin(), values.end(), [=](double x) { return !(x >= low && x <= high); }));
}

double count_others(const Values& values, std::initializer_list<double> allowed) {
  return double(std::count_if(values.begin(), values.end(),
                              [=](double x) { return std::find(allowed.begin(), allowed.end(), x) == allowed.end(); }));
}

std::size_t count_non_finite(const Values& values) {
  return std::size_t(std::count_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); }));
}

bool has_nan(const Values& values) {
  return std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); });
}

double difference(const Values& actual, const Values& expected) {
  return largest(actual, expected, [](double a, double e) { return std::abs(a - e); });
}

double relative_difference(const Values& actual, const Values& expected) {
  double size = 0;
  for (const double e : expected) size = std::max(size, std::abs(e));
  return largest(actual, expected, [=](double a, double e) { return std::abs(a - e) / size; });
}

double each_relative(const Values& actual, const Values& expected) {
  return largest(actual, expected, [](double a, double e) { return std::abs(a - e) / std::abs(e); });
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  const double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);
  if (sine == 0 && cosine == 0) return double(infinite);
  const double angle = std::atan2(sine, cosine) * 180 / std::numbers::pi;
  return std::isnan(angle) ? double(infinite) : angle;
}

double not_rigid(const glm::mat4& m) {
  const glm::dmat3 r(m);
  return std::max(difference(values(glm::transpose(r) * r), values(glm::dmat3(1))), std::abs(glm::determinant(r) - 1));
}

}  // namespace atelier::stability
