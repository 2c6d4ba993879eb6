#include "shadow-demo/lit_fragment.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace atelier::shadow_demo {

namespace {

constexpr const char* inputs = R"(
in vec3 v_position, v_normal;
in vec2 v_texcoord;
uniform sampler2D u_wood;
uniform vec3 u_eye, u_ambient, u_light_colour, u_diffuse, u_specular;
uniform float u_exponent;
out vec4 o_colour;
)";

constexpr const char* colour = R"(
void main() {
  vec3 wood = u_diffuse * texture(u_wood, v_texcoord).rgb;
  vec3 normal = normalize(v_normal), light = to_light();
  vec3 between = normalize(light + normalize(u_eye - v_position));
  float highlight = pow(max(dot(normal, between), 0.0), u_exponent);
  vec3 reflected = (wood + u_specular * highlight) * max(dot(normal, light), 0.0);
  o_colour = vec4(wood * u_ambient + (1.0 - shadow(normal)) * u_light_colour * reflected, 1.0);
}
)";

constexpr const char* factor = "void main() { o_colour = vec4(vec3(1.0 - shadow(normalize(v_normal))), 1.0); }\n";

}  // namespace

Program build(Gl& gl, const std::string& vertex, const std::string& fragment, const std::string& geometry) {
  const FindFile no_includes = [](const std::string&) { return std::filesystem::path(); };
  const auto stage = [&](const std::string& text) {
    return assemble_shader_text(no_includes, text, "shadow-demo", {});
  };
  const ShaderSource layered = stage(geometry);
  GlProgram program = build_program(gl, stage(vertex), stage(fragment), geometry.empty() ? nullptr : &layered);
  Uniforms uniforms(gl, program.id());
  return {std::move(program), std::move(uniforms)};
}

std::string lit_fragment(const std::string& shadow, bool shadow_factor) {
  return inputs + shadow + (shadow_factor ? factor : colour);
}

void begin_picture(Gl& gl, const Frame& frame, const Scene& scene) {
  frame.target.bind(gl);
  const glm::vec3 background = frame.output == "colour" ? scene.background : glm::vec3(0);
  gl.ClearColor(background.r, background.g, background.b, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void set_common(Gl& gl, Program& program, const Frame& frame, const DemoScene& demo) {
  const Camera& camera = frame.camera;
  const TargetSpec& size = frame.target.spec();
  const glm::vec3 eye(camera.eye), target(camera.target);
  Uniforms& uniforms = program.uniforms;
  gl.UseProgram(program.program.id());
  uniforms.set("u_projection",
               glm::perspective(camera.fov_y, float(size.width) / float(size.height), camera.near, camera.far));
  uniforms.set("u_view", glm::lookAt(eye, target, camera.up));
  uniforms.set("u_eye", eye);
  uniforms.set("u_ambient", demo.scene().ambient);
  uniforms.set("u_light_colour", demo.scene().lights.front().colour);
  uniforms.set("u_diffuse", demo.material().diffuse);
  uniforms.set("u_specular", demo.material().specular);
  uniforms.set("u_exponent", demo.material().exponent);
  uniforms.set("u_wood", 0);
  uniforms.set("u_map", 1);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, demo.texture());
}

}  // namespace atelier::shadow_demo
