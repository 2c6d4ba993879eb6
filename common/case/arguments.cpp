// Arguments: converts named numbers to the parameter types of the functions that a probe calls.
#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "case/case.hpp"

namespace atelier {
namespace {

const std::vector<double>& exactly(const Arguments& arguments, const std::string& name, std::size_t count) {
  const std::vector<double>& values = arguments.numbers(name);
  if (values.size() == count) return values;
  throw Error(fmt::format("argument '{}' has {} numbers; {} are needed", name, values.size(), count));
}

}  // namespace

const std::vector<double>& Arguments::numbers(const std::string& name) const {
  if (const auto found = values.find(name); found != values.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, unused] : values) known.push_back(other);
  throw Error(fmt::format("no argument '{}'{}", name, suggestion(name, known)));
}

double Arguments::number(const std::string& name) const {
  return exactly(*this, name, 1)[0];
}

int Arguments::integer(const std::string& name) const {
  const double value = number(name);
  const bool fits = value == std::trunc(value) && std::abs(value) <= 2147483647.0;  // false for a NaN
  if (!fits) throw Error(fmt::format("argument '{}' is {}; a whole number is needed", name, value));
  return int(value);
}

glm::dvec2 Arguments::vec2(const std::string& name) const {
  const auto& v = exactly(*this, name, 2);
  return {v[0], v[1]};
}

glm::dvec3 Arguments::vec3(const std::string& name) const {
  const auto& v = exactly(*this, name, 3);
  return {v[0], v[1], v[2]};
}

glm::dvec4 Arguments::vec4(const std::string& name) const {
  const auto& v = exactly(*this, name, 4);
  return {v[0], v[1], v[2], v[3]};
}

glm::dmat4 Arguments::mat4(const std::string& name) const {
  const auto& v = exactly(*this, name, 16);
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) matrix[column][row] = v[column * 4 + row];
  }
  return matrix;
}

}  // namespace atelier
