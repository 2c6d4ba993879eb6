// The table of step 10, a function for each part of its contract.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>

#include "10-artstyles/artstyles.hpp"
#include "stability/calls.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_edge_rows(Table& table, ShaderFunctions& shaders);
void add_toon_rows(Table& table, ShaderFunctions& shaders);
void add_steps_rows(Table& table, ShaderFunctions& shaders);
void add_power_source_rows(Table& table, ShaderFunctions& shaders);
void add_direction_rows(Table& table, ShaderFunctions& shaders);
void add_in_direction_rows(Table& table, ShaderFunctions& shaders);
void add_aberrated_rows(Table& table, ShaderFunctions& shaders);
void add_fisheye_place_rows(Table& table, ShaderFunctions& shaders);
void add_power_place_rows(Table& table, ShaderFunctions& shaders);
void add_distorted_rows(Table& table, ShaderFunctions& shaders);
void add_centres_rows(Table& table);
void add_radius_rows(Table& table);
void add_stroke_rows(Table& table);
void add_regions_rows(Table& table);

/// An expression over the step's shader functions. `helpers` is GLSL behind the include.
ShaderFunction style_function(std::vector<std::string> parameters, std::string expression,
                              const std::string& helpers = "");

/// The results of any number of calls, in as many draws as they need.
std::vector<glm::vec4> results_of(ShaderFunctions& shaders, const ShaderFunction& function,
                                  const std::vector<ShaderInput>& inputs);

/// The larger of all error(call, result), evaluated in as many draws as needed; infinite where one is NaN.
double worst_result(ShaderFunctions& shaders, const ShaderFunction& function, const std::vector<ShaderInput>& calls,
                    const std::function<double(const ShaderInput&, const glm::vec4&)>& error);

/// How many of the calls have an error above 1; a NaN is.
double count_failed(ShaderFunctions& shaders, const ShaderFunction& function, const std::vector<ShaderInput>& calls,
                    const std::function<double(const ShaderInput&, const glm::vec4&)>& error);

inline constexpr float pi = std::numbers::pi_v<float>;

/// What a sine or cosine may be off: GLSL demands nothing.
inline constexpr double sine_error = 2e-6;

/// Pictures of unusual shapes among them.
inline constexpr std::array sizes = {glm::vec2(1, 1), glm::vec2(1920, 1080), glm::vec2(1, 16384), glm::vec2(16384, 1)};

/// The places of a polar grid of 146 directions and 84 distances, 12264 in all: distance and angle of each. The
/// distances are evenly spread over 0 .. `farthest`; neither end is among them.
std::vector<glm::dvec2> polar_grid(double farthest);
inline constexpr int polar_count = 146 * 84;

/// Texture coordinates of a place in half heights from the centre, and back.
glm::vec2 texcoord_of(const glm::dvec2& place, const glm::vec2& size);
glm::dvec2 place_of(const glm::vec2& texcoord, const glm::vec2& size);

/// What a rounding of the texture coordinates costs, in half heights.
double texcoord_rounding(const glm::vec2& texcoord, const glm::vec2& size);

/// How far pow(base, exponent) may be off, relative: later GLSL demands of exp2(exponent * log2(base)) that its
/// logarithm is good to 3 of its last places or 2^-21, and exp2(x) to 3 + 2 |x|.
double pow_error(double base, double exponent);

}  // namespace atelier::stability
