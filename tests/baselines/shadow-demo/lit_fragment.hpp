// What both demos' second passes have in common: a textured Blinn-Phong surface under one light.
#pragma once

#include <string>

#include "app/step_program.hpp"
#include "gl/shader.hpp"
#include "shadow-demo/demo_scene.hpp"

namespace atelier::shadow_demo {

struct Program {
  GlProgram program;
  Uniforms uniforms;
};

Program build(Gl& gl, const std::string& vertex, const std::string& fragment, const std::string& geometry = {});

/// The fragment shader: `shadow` defines `vec3 to_light()` and `float shadow(vec3 normal)`, 1 in shadow, and finds its
/// map as u_map; v_position, v_normal and v_texcoord come from the vertex shader. Writes the colour or 1 - shadow.
std::string lit_fragment(const std::string& shadow, bool shadow_factor);

/// Binds the frame's target and clears it: to the scene's background, or where no colours are drawn to black.
void begin_picture(Gl& gl, const Frame& frame, const Scene& scene);

/// Takes the program in use and sets all that does not belong to a node or to the light's map: camera, light, material,
/// texture units (0 the wood, 1 the map).
void set_common(Gl& gl, Program& program, const Frame& frame, const DemoScene& demo);

}  // namespace atelier::shadow_demo
