// A program of GLSL texts, and how its uniforms are set.
#pragma once

#include <string>

#include "gl/shader.hpp"

namespace atelier::demo {

struct Program {
  GlProgram program;
  Uniforms uniforms;
};

/// Of GLSL texts without includes; `geometry` may be empty. Error messages name `demo`.
Program build(Gl& gl, const char* demo, const std::string& vertex, const std::string& fragment,
              const std::string& geometry = {});

}  // namespace atelier::demo
