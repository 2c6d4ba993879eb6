// The table of step 09, a function for each part of its contract.
#pragma once

#include <cstdint>
#include <limits>

#include "09-dithering/dithering.hpp"
#include "stability/calls.hpp"
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

/// An expression over the step's shader functions.
ShaderFunction dither_function(std::vector<std::string> parameters, std::string expression);

/// The first components of any number of calls, in as many draws as they need.
Values numbers_of_calls(ShaderFunctions& shaders, const ShaderFunction& function,
                        const std::vector<ShaderInput>& inputs);

}  // namespace atelier::stability
