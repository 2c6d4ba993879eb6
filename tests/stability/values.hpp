// Whatever a function gives, as a list of numbers, and the distances between such lists.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <initializer_list>
#include <vector>

namespace atelier::stability {

using Values = std::vector<double>;

/// Half the distance from 1 to the next float: what one rounding may cost, relative to the result.
inline constexpr double rounding_unit = 0x1p-24;

template <int N, class T>
Values values(const glm::vec<N, T>& v) {
  Values out;
  for (int i = 0; i < N; ++i) out.push_back(double(v[i]));
  return out;
}

/// Column by column.
template <int C, int R, class T>
Values values(const glm::mat<C, R, T>& m) {
  Values out;
  for (int column = 0; column < C; ++column)
    for (int row = 0; row < R; ++row) out.push_back(double(m[column][row]));
  return out;
}

/// Lists one behind the other.
template <class Container>
Values all_values(const Container& items) {
  Values out;
  for (const auto& item : items) {
    const Values some = values(item);
    out.insert(out.end(), some.begin(), some.end());
  }
  return out;
}

/// How many are outside of low..high; a NaN is.
double count_outside(const Values& values, double low, double high);

/// How many are none of the allowed numbers.
double count_others(const Values& values, std::initializer_list<double> allowed);

std::size_t count_non_finite(const Values& values);
bool has_nan(const Values& values);

/// The largest |actual - expected|; infinite where a number is NaN or the lengths differ.
double difference(const Values& actual, const Values& expected);

/// The same as a share of the largest |expected|: for numbers that make sense together only, as those of a vector do.
double relative_difference(const Values& actual, const Values& expected);

/// The largest |actual - expected| / |expected| of a single number. Where 0 is expected, only 0 is right.
double each_relative(const Values& actual, const Values& expected);

/// The angle between two directions of any length but zero, in degrees, exact for small angles too (by the arc tangent
/// of sine and cosine); infinite where one is zero or not finite.
double degrees_between(const glm::dvec3& a, const glm::dvec3& b);

/// How far m is from keeping lengths, angles and handedness: R^T R from the identity, det R from 1, for its upper left
/// 3x3.
double not_rigid(const glm::mat4& m);

}  // namespace atelier::stability
