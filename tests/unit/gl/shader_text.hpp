// Shaders that a test writes out: no file, nothing to include.
#pragma once

#include <filesystem>
#include <string>

#include "gl/shader.hpp"

namespace atelier::test {

inline ShaderSource shader_text(const std::string& glsl, const std::string& label = "test",
                                const Defines& defines = {}) {
  return assemble_shader_text([](const std::string&) { return std::filesystem::path(); }, glsl, label, defines);
}

}  // namespace atelier::test
