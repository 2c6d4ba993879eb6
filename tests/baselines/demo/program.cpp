#include "demo/program.hpp"

namespace atelier::demo {

Program build(Gl& gl, const char* demo, const std::string& vertex, const std::string& fragment,
              const std::string& geometry) {
  const FindFile no_includes = [](const std::string&) { return std::filesystem::path(); };
  const auto stage = [&](const std::string& text) { return assemble_shader_text(no_includes, text, demo, {}); };
  const ShaderSource layered = stage(geometry);
  GlProgram program = build_program(gl, stage(vertex), stage(fragment), geometry.empty() ? nullptr : &layered);
  Uniforms uniforms(gl, program.id());
  return {std::move(program), std::move(uniforms)};
}

}  // namespace atelier::demo
