#include "relief-demo/shaders.hpp"

namespace atelier::relief_demo {

namespace {

constexpr const char* vertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
layout(location = 3) in vec3 a_tangent;
uniform mat4 u_model, u_view, u_projection;
uniform vec3 u_eye, u_lamp;
out vec2 v_texcoord;
out vec3 v_position_tangent, v_eye_tangent, v_lamp_tangent;
out mat3 v_tangent_to_world;
void main() {
  vec3 position = vec3(u_model * vec4(a_position, 1.0));
  vec3 n = normalize(transpose(inverse(mat3(u_model))) * a_normal);
  vec3 t = normalize(mat3(u_model) * a_tangent);
  t = normalize(t - dot(t, n) * n);
  v_tangent_to_world = mat3(t, cross(n, t), n);
  mat3 world_to_tangent = transpose(v_tangent_to_world);
  v_texcoord = a_texcoord;
  v_position_tangent = world_to_tangent * position;
  v_eye_tangent = world_to_tangent * u_eye;
  v_lamp_tangent = world_to_tangent * u_lamp;
  gl_Position = u_projection * u_view * vec4(position, 1.0);
}
)";

constexpr const char* fragment_inputs = R"(
in vec2 v_texcoord;
in vec3 v_position_tangent, v_eye_tangent, v_lamp_tangent;
in mat3 v_tangent_to_world;
uniform sampler2D u_colours, u_normals, u_depths;
uniform vec3 u_ambient, u_light_colour, u_attenuation, u_diffuse, u_specular;
uniform float u_exponent, u_depth;
out vec4 o_colour;
)";

constexpr const char* flat_wall = "vec2 displaced(vec2 texcoord, vec3 to_eye) { return texcoord; }\n";

constexpr const char* deep_wall = R"(
vec2 displaced(vec2 texcoord, vec3 to_eye) {
  const float least = 8.0, most = 32.0;
  float layers = mix(most, least, abs(to_eye.z));
  float layer = 1.0 / layers;
  vec2 texcoord_step = to_eye.xy / to_eye.z * u_depth / layers;
  float ray = 0.0, stored = texture(u_depths, texcoord).r;
  while (ray < stored) {
    texcoord -= texcoord_step;
    stored = texture(u_depths, texcoord).r;
    ray += layer;
  }
  vec2 previous = texcoord + texcoord_step;
  float after = stored - ray, before = texture(u_depths, previous).r - ray + layer;
  float weight = after / (after - before);
  texcoord = previous * weight + texcoord * (1.0 - weight);
  if (texcoord.x > 1.0 || texcoord.y > 1.0 || texcoord.x < 0.0 || texcoord.y < 0.0) discard;
  return texcoord;
}
)";

constexpr const char* colour = R"(
void main() {
  vec3 to_eye = normalize(v_eye_tangent - v_position_tangent);
  vec2 texcoord = displaced(v_texcoord, to_eye);
  vec3 normal = normalize(texture(u_normals, texcoord).rgb * 2.0 - 1.0);
  vec3 surface = u_diffuse * texture(u_colours, texcoord).rgb;
  vec3 way = v_lamp_tangent - v_position_tangent;
  float metres = length(way);
  vec3 to_lamp = way / metres;
  float highlight = pow(max(dot(normal, normalize(to_lamp + to_eye)), 0.0), u_exponent);
  vec3 reflected = (surface + u_specular * highlight) * max(dot(normal, to_lamp), 0.0);
  float attenuation = dot(u_attenuation, vec3(1.0, metres, metres * metres));
  o_colour = vec4(surface * u_ambient + u_light_colour / attenuation * reflected, 1.0);
}
)";

constexpr const char* normal = R"(
void main() {
  vec2 texcoord = displaced(v_texcoord, normalize(v_eye_tangent - v_position_tangent));
  vec3 normal = normalize(v_tangent_to_world * normalize(texture(u_normals, texcoord).rgb * 2.0 - 1.0));
  o_colour = vec4(0.5 * normal + 0.5, 1.0);
}
)";

constexpr const char* texture_coordinate = R"(
void main() {
  o_colour = vec4(displaced(v_texcoord, normalize(v_eye_tangent - v_position_tangent)), 0.0, 1.0);
}
)";

}  // namespace

std::string wall_vertex() {
  return vertex;
}

std::string wall_fragment(bool parallax, const std::string& output) {
  const char* main = output == "normal" ? normal : output == "texcoord" ? texture_coordinate : colour;
  return std::string(fragment_inputs) + (parallax ? deep_wall : flat_wall) + main;
}

}  // namespace atelier::relief_demo
