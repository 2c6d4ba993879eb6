// The table of step 08, a function for each part of its contract.
#pragma once

#include "08-post-processing/post_processing.hpp"
#include "stability/08-post-processing/colours.hpp"
#include "stability/calls.hpp"
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

}  // namespace atelier::stability
