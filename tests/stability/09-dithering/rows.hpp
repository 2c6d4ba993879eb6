// The table of step 09, a function for each part of its contract.
#pragma once

#include <cstdint>
#include <limits>

#include "09-dithering/dithering.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_bayer_rows(Table& table);
void add_threshold_rows(Table& table, ShaderFunctions& shaders);
void add_level_rows(Table& table, ShaderFunctions& shaders);
void add_shares_rows(Table& table);
void add_diffused_rows(Table& table);
void add_diffused_exactly_rows(Table& table);
void add_place_rows(Table& table, ShaderFunctions& shaders);
void add_edge_rows(Table& table, ShaderFunctions& shaders);
void add_noise_rows(Table& table);
void add_bitmap_rows(Table& table);
void add_octave_rows(Table& table, ShaderFunctions& shaders);
void add_surface_rows(Table& table, ShaderFunctions& shaders);
void add_mixed_rows(Table& table, ShaderFunctions& shaders);
void add_fast_rows(Table& table);

inline constexpr int least_int = std::numeric_limits<int>::min();
inline constexpr int largest_int = std::numeric_limits<int>::max();

/// An expression over the step's shader functions.
ShaderFunction dither_function(std::vector<std::string> parameters, std::string expression);

/// The first components of any number of calls, in as many draws as they need.
Values numbers_of_calls(ShaderFunctions& shaders, const ShaderFunction& function,
                        const std::vector<ShaderInput>& inputs);

/// The larger error; infinite if the new one is NaN.
inline double worse_of(double worst, double error) {
  if (std::isnan(error)) return double(INFINITY);
  return std::max(worst, error);
}

/// The largest error over `count` trials, which are evaluated in one draw: arguments(trial) is a call, and error(call,
/// result) says how far what came out is from what should. Infinite where one is NaN.
template <class Arguments, class Error>
double worst_of_calls(ShaderFunctions& shaders, const ShaderFunction& function, int count, std::uint64_t seed,
                      Arguments&& arguments, Error&& error) {
  std::vector<ShaderInput> calls;
  for (int i = 0; i < count; ++i) {
    Trial t(seed, i);
    calls.push_back(arguments(t));
  }
  const std::vector<glm::vec4> found = shaders.evaluate(function, calls);
  double worst = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) worst = worse_of(worst, error(calls[i], found[i]));
  return worst;
}

/// A row: the same call in 64 pixels, one of which has a NaN as its first argument instead. The others come out as they
/// do without it.
void add_nan_row(Group& group, ShaderFunctions& shaders, const ShaderFunction& function, const ShaderInput& call);

}  // namespace atelier::stability
