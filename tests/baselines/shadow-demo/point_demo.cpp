// A depth cube of 1024 x 1024 texels a face, drawn at once by a geometry shader, everything drawn into it: distances as
// shares of the far plane's, compared once a pixel with a fixed bias.
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "04-point-shadows/given/cube_room.hpp"
#include "shadow-demo/two_pass_demo.hpp"

namespace atelier::shadow_demo {

namespace {

constexpr float near_plane = 1, far_plane = 25;  // metres

constexpr const char* to_world_vertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_model;
void main() { gl_Position = u_model * vec4(a_position, 1.0); }
)";

constexpr const char* depth_geometry = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 18) out;
uniform mat4 u_faces[6];
out vec3 g_position;
void main() {
  for (int face = 0; face < 6; ++face) {
    gl_Layer = face;
    for (int corner = 0; corner < 3; ++corner) {
      g_position = gl_in[corner].gl_Position.xyz;
      gl_Position = u_faces[face] * gl_in[corner].gl_Position;
      EmitVertex();
    }
    EndPrimitive();
  }
}
)";

constexpr const char* depth_fragment = R"(
in vec3 g_position;
uniform vec3 u_lamp;
uniform float u_far;
void main() { gl_FragDepth = length(g_position - u_lamp) / u_far; }
)";

constexpr const char* lamp_shadow = R"(
uniform samplerCube u_map;
uniform vec3 u_lamp;
uniform float u_far;
vec3 to_light() { return normalize(u_lamp - v_position); }

float shadow(vec3 normal) {
  vec3 from_lamp = v_position - u_lamp;
  float nearest = texture(u_map, from_lamp).r * u_far;
  return length(from_lamp) - 0.05 > nearest ? 1.0 : 0.0;
}
)";

DepthMap make_cube_map(Gl& gl) {
  DepthMap map{GL_TEXTURE_CUBE_MAP, 1024, GlTexture(gl)};
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, map.texture.id());
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_DEPTH_COMPONENT24, map.resolution, map.resolution, 0,
                  GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, axis, GL_CLAMP_TO_EDGE);
  return map;
}

/// World to clip space of the six faces, in OpenGL's order (OpenGL 3.3, table 3.11): +x, -x, +y, -y, +z, -z.
std::array<glm::mat4, 6> faces_around(const glm::vec3& lamp) {
  const std::pair<glm::vec3, glm::vec3> looks[] = {{{1, 0, 0}, {0, -1, 0}}, {{-1, 0, 0}, {0, -1, 0}},
                                                   {{0, 1, 0}, {0, 0, 1}},  {{0, -1, 0}, {0, 0, -1}},
                                                   {{0, 0, 1}, {0, -1, 0}}, {{0, 0, -1}, {0, -1, 0}}};
  const glm::mat4 projection = glm::perspective(glm::radians(90.0f), 1.0f, near_plane, far_plane);
  std::array<glm::mat4, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) faces[i] = projection * glm::lookAt(lamp, lamp + looks[i].first, looks[i].second);
  return faces;
}

class PointDemo : public TwoPassDemo {
 public:
  PointDemo(Gl& gl, bool compact_textures)
      : TwoPassDemo(gl, DemoScene(gl, make_cube_room_scene(), compact_textures), make_cube_map(gl),
                    demo::build(gl, name, to_world_vertex, depth_fragment, depth_geometry), lit_vertex(), lamp_shadow) {
  }

 private:
  glm::vec3 lamp() const { return glm::vec3(scene().lights.front().position); }

  void set_depth_light(Uniforms& uniforms) override {
    const std::array<glm::mat4, 6> faces = faces_around(lamp());
    for (std::size_t i = 0; i < faces.size(); ++i) uniforms.set("u_faces[" + std::to_string(i) + "]", faces[i]);
    set_light(uniforms);
  }

  void set_light(Uniforms& uniforms) override {
    uniforms.set("u_lamp", lamp());
    uniforms.set("u_far", far_plane);
  }
};

}  // namespace

std::unique_ptr<Demo> make_point_demo(Gl& gl, bool compact_textures) {
  return std::make_unique<PointDemo>(gl, compact_textures);
}

}  // namespace atelier::shadow_demo
