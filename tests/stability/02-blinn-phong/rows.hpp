// The table of step 02, a function for each part of its contract.
#pragma once

#include "02-blinn-phong/blinn_phong.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_colour_rows(Table& table, ShaderFunctions& shaders);
void add_texture_rows(Table& table, ShaderFunctions& shaders);
void add_energy_rows(Table& table, ShaderFunctions& shaders);
void add_light_rows(Table& table, ShaderFunctions& shaders);
void add_highlight_rows(Table& table, ShaderFunctions& shaders);
void add_reflected_rows(Table& table, ShaderFunctions& shaders);
void add_shade_rows(Table& table, ShaderFunctions& shaders);

/// Which variant of the shader: the defines that the program sets.
struct Variant {
  int power = 0, normalisation = 0;
  bool specular = true;
  int point_lights = 1, spot_lights = 1, directional_lights = 1;
};

/// An expression over the step's shader functions. `helpers` is GLSL behind the include.
ShaderFunction blinn_phong_function(std::vector<std::string> parameters, std::string expression,
                                    const Variant& variant = {}, const std::string& helpers = "");

}  // namespace atelier::stability
