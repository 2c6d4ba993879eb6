// Many calls of a shader function in one draw.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "stability/random.hpp"
#include "stability/shader_function.hpp"

namespace atelier::stability {

/// The larger error; infinite if the new one is NaN.
inline double worse_of(double worst, double error) {
  if (std::isnan(error)) return double(INFINITY);
  return std::max(worst, error);
}

/// The largest error over `count` trials, which are evaluated in one draw: arguments(trial) is a call, and error(call,
/// result) says how far what came out is from what should. Infinite where one is NaN.
template <class Result = glm::vec4, class Arguments, class Error>
double worst_of_calls(ShaderFunctions& shaders, const ShaderFunction& function, int count, std::uint64_t seed,
                      Arguments&& arguments, Error&& error) {
  std::vector<ShaderInput> calls;
  for (int i = 0; i < count; ++i) {
    Trial t(seed, i);
    calls.push_back(arguments(t));
  }
  const std::vector<glm::vec4> found = shaders.evaluate(function, calls);
  double worst = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) worst = worse_of(worst, error(calls[i], Result(found[i])));
  return worst;
}

}  // namespace atelier::stability
