#include "shadow-demo/lit_shaders.hpp"

namespace atelier::shadow_demo {

namespace {

constexpr const char* vertex_inputs = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
uniform mat4 u_model, u_view, u_projection;
out vec3 v_position, v_normal;
out vec2 v_texcoord;
)";

constexpr const char* vertex_main = R"(
void main() {
  v_position = vec3(u_model * vec4(a_position, 1.0));
  v_normal = transpose(inverse(mat3(u_model))) * a_normal;
  v_texcoord = a_texcoord;
  gl_Position = u_projection * u_view * vec4(v_position, 1.0);
)";

constexpr const char* fragment_inputs = R"(
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

std::string lit_vertex(const std::string& declarations, const std::string& statements) {
  return vertex_inputs + declarations + vertex_main + statements + "}\n";
}

std::string lit_fragment(const std::string& shadow, bool shadow_factor) {
  return fragment_inputs + shadow + (shadow_factor ? factor : colour);
}

}  // namespace atelier::shadow_demo
