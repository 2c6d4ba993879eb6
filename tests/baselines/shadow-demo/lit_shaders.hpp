// The shaders of both demos' pictures: a textured Blinn-Phong surface under one light.
#pragma once

#include <string>

namespace atelier::shadow_demo {

/// The vertex shader: writes v_position, v_normal (world space) and v_texcoord. `declarations` and `statements`, which
/// come last, add what a light needs besides.
std::string lit_vertex(const std::string& declarations = {}, const std::string& statements = {});

/// The fragment shader: `shadow` defines `vec3 to_light()` and `float shadow(vec3 normal)`, 1 in shadow, and finds its
/// map as u_map; v_position, v_normal and v_texcoord come from the vertex shader. Writes the colour or 1 - shadow.
std::string lit_fragment(const std::string& shadow, bool shadow_factor);

}  // namespace atelier::shadow_demo
