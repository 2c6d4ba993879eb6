// The table of step 03, a function for each part of its contract.
#pragma once

#include "03-shadow-mapping/shadow_mapping.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_fit_rows(Table& table);
void add_matrix_rows(Table& table, ShaderFunctions& shaders);
void add_snap_rows(Table& table);
void add_coordinate_rows(Table& table, ShaderFunctions& shaders);
void add_bias_rows(Table& table, ShaderFunctions& shaders);
void add_lookup_rows(Table& table, ShaderFunctions& shaders);
void add_soft_rows(Table& table, ShaderFunctions& shaders);
void add_factor_rows(Table& table, ShaderFunctions& shaders);

/// The direction this many degrees off (0, 1, 0), in the plane of x and y.
inline glm::vec3 slanted(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return glm::vec3(std::sin(a), std::cos(a), 0);
}

/// Which variant of the shader: the defines that the program sets.
struct Variant {
  int bias = 0, pcf = 1;
  bool compare = false;
  int samples = 0;  ///< of PCSS; 0: without
  bool random = false;
};

/// An expression over the step's shader functions.
ShaderFunction shadow_function(std::vector<std::string> parameters, std::string expression,
                               const Variant& variant = {});

/// GLSL for a light at the origin that looks down, of which only what `in` (half-width, near, far, width) and
/// `directional` (1 or 0) say matters.
inline constexpr const char* plain_light =
    "ShadowLight(mat4(1.0), vec3(0.0), vec3(0.0, -1.0, 0.0), in_light.x, in_light.y, in_light.z, in_light.w, "
    "directional.x > "
    "0.5, 0)";

/// A depth map of one layer, square, row by row from v = 0; read, or compared and mixed, as the contract has it.
class DepthMap {
 public:
  DepthMap(Gl& gl, std::initializer_list<float> depths, bool compare = false);
  /// A shader function that looks it up.
  ShaderFunction read_by(ShaderFunction function) const;

 private:
  GlTexture texture_;
};

}  // namespace atelier::stability
