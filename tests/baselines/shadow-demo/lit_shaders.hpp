// The shaders of both demos' pictures: a textured Blinn-Phong surface under one light.
#pragma once

#include <string>

#include "gl/shader.hpp"

namespace atelier::shadow_demo {

struct Program {
  GlProgram program;
  Uniforms uniforms;
};

/// Of GLSL texts without includes; `geometry` may be empty.
Program build(Gl& gl, const std::string& vertex, const std::string& fragment, const std::string& geometry = {});

/// The vertex shader: writes v_position, v_normal (world space) and v_texcoord. `declarations` and `statements`, which
/// come last, add what a light needs besides.
std::string lit_vertex(const std::string& declarations = {}, const std::string& statements = {});

/// The fragment shader: `shadow` defines `vec3 to_light()` and `float shadow(vec3 normal)`, 1 in shadow, and finds its
/// map as u_map; v_position, v_normal and v_texcoord come from the vertex shader. Writes the colour or 1 - shadow.
std::string lit_fragment(const std::string& shadow, bool shadow_factor);

}  // namespace atelier::shadow_demo
