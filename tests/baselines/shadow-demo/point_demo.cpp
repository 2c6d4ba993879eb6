// A depth cube of 1024 x 1024 texels a face, drawn at once by a geometry shader, everything drawn into it: distances as
// shares of the far plane's, compared once a pixel with a fixed bias.
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "04-point-shadows/cube_room.hpp"
#include "shadow-demo/demo.hpp"
#include "shadow-demo/demo_scene.hpp"
#include "shadow-demo/lit_fragment.hpp"

namespace atelier::shadow_demo {

namespace {

constexpr int resolution = 1024;                 // texels a side of each face
constexpr float near_plane = 1, far_plane = 25;  // metres

constexpr const char* depth_vertex = R"(
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

constexpr const char* lit_vertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
uniform mat4 u_model, u_view, u_projection;
out vec3 v_position, v_normal;
out vec2 v_texcoord;
void main() {
  v_position = vec3(u_model * vec4(a_position, 1.0));
  v_normal = transpose(inverse(mat3(u_model))) * a_normal;
  v_texcoord = a_texcoord;
  gl_Position = u_projection * u_view * vec4(v_position, 1.0);
}
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

GlTexture make_map(Gl& gl) {
  GlTexture map(gl);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, map.id());
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_DEPTH_COMPONENT24, resolution, resolution, 0,
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

class PointDemo : public Demo {
 public:
  explicit PointDemo(Gl& gl)
      : gl_(gl),
        demo_(gl, make_cube_room_scene()),
        depth_(build(gl, depth_vertex, depth_fragment, depth_geometry)),
        colour_(build(gl, lit_vertex, lit_fragment(lamp_shadow, false))),
        factor_(build(gl, lit_vertex, lit_fragment(lamp_shadow, true))),
        map_(make_map(gl)),
        framebuffer_(gl) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, map_.id(), 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    check_gl_error(gl, "making the demo's depth cube");
  }

  const Scene& scene() const override { return demo_.scene(); }

  void draw(const Frame& frame, bool shadow_factor) override {
    const glm::vec3 lamp(scene().lights.front().position);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.Viewport(0, 0, resolution, resolution);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.UseProgram(depth_.program.id());
    const std::array<glm::mat4, 6> faces = faces_around(lamp);
    for (std::size_t i = 0; i < faces.size(); ++i) depth_.uniforms.set("u_faces[" + std::to_string(i) + "]", faces[i]);
    set_lamp(depth_, lamp);
    demo_.draw(gl_, depth_.uniforms);

    begin_picture(gl_, frame, scene());
    Program& program = shadow_factor ? factor_ : colour_;
    set_common(gl_, program, frame, demo_);
    set_lamp(program, lamp);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_CUBE_MAP, map_.id());
    gl_.ActiveTexture(GL_TEXTURE0);
    demo_.draw(gl_, program.uniforms);
    check_gl_error(gl_, "drawing the demo");
  }

 private:
  static void set_lamp(Program& program, const glm::vec3& lamp) {
    program.uniforms.set("u_lamp", lamp);
    program.uniforms.set("u_far", far_plane);
  }

  Gl& gl_;
  DemoScene demo_;
  Program depth_, colour_, factor_;
  GlTexture map_;
  GlFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Demo> make_point_demo(Gl& gl) {
  return std::make_unique<PointDemo>(gl);
}

}  // namespace atelier::shadow_demo
