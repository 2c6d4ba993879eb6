// The table of step 08, a function for each part of its contract.
#pragma once

#include "08-post-processing/post_processing.hpp"
#include "stability/08-post-processing/colours.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_target_rows(Table& table);
void add_full_screen_rows(Table& table, ShaderFunctions& shaders);
void add_passes_rows(Table& table);
void add_luma_rows(Table& table, ShaderFunctions& shaders);
void add_parts_rows(Table& table, ShaderFunctions& shaders);
void add_colour_rows(Table& table, ShaderFunctions& shaders);
void add_round_trip_rows(Table& table, ShaderFunctions& shaders);
void add_adjusted_rows(Table& table, ShaderFunctions& shaders);
void add_reinhard_rows(Table& table, ShaderFunctions& shaders);
void add_filmic_rows(Table& table, ShaderFunctions& shaders);
void add_tone_rows(Table& table, ShaderFunctions& shaders);
void add_overlaid_rows(Table& table, ShaderFunctions& shaders);
void add_bright_rows(Table& table, ShaderFunctions& shaders);
void add_weights_rows(Table& table);
void add_blurred_rows(Table& table, ShaderFunctions& shaders);
void add_lookup_rows(Table& table, ShaderFunctions& shaders);
void add_dithered_rows(Table& table, ShaderFunctions& shaders);
void add_read_rows(Table& table);
void add_write_rows(Table& table);

inline constexpr float largest_half = 65504;  ///< of the 16-bit floats in which a chain may keep its pictures

/// An expression over the step's shader functions. `helpers` is GLSL behind the include.
ShaderFunction post_function(std::vector<std::string> parameters, std::string expression,
                             const std::string& helpers = "");

/// Reinhard's and Hable's curve, in double precision.
Colour exact_reinhard(const Colour& c, double white);
double exact_filmic(double x);

/// What the functions of GLSL give for these calls: three numbers each.
Values colours_of(ShaderFunctions& shaders, const ShaderFunction& function, const std::vector<ShaderInput>& inputs);

/// The largest error over `count` trials, which are evaluated in one draw: arguments(trial) is a call, and error(call,
/// colour) says how far what came out is from what should. Infinite where one is NaN.
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
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const double here = error(calls[i], Colour(found[i]));
    if (!(here <= worst)) worst = std::isnan(here) ? double(INFINITY) : here;
  }
  return worst;
}

/// A row: 64 pixels with the colour of `call`, its first argument, one of which is NaN instead. The others come out as
/// they do without it. `words` stand in front of its text.
void add_nan_row(Group& group, ShaderFunctions& shaders, const ShaderFunction& function, const ShaderInput& call,
                 const std::string& words = "");

}  // namespace atelier::stability
