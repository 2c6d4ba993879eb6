// One depth map of 1024 x 1024 texels over a fixed box, everything drawn into it, 3 x 3 comparisons a pixel.
#include <glm/gtc/matrix_transform.hpp>

#include "03-shadow-mapping/cubes.hpp"
#include "shadow-demo/demo.hpp"
#include "shadow-demo/demo_scene.hpp"
#include "shadow-demo/lit_fragment.hpp"

namespace atelier::shadow_demo {

namespace {

constexpr int resolution = 1024;  // texels a side
constexpr glm::vec3 lamp{-2, 4, -1};

constexpr const char* depth_vertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_model, u_world_to_light;
void main() { gl_Position = u_world_to_light * u_model * vec4(a_position, 1.0); }
)";

constexpr const char* lit_vertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
uniform mat4 u_model, u_view, u_projection, u_world_to_light;
out vec3 v_position, v_normal;
out vec2 v_texcoord;
out vec4 v_position_light;
void main() {
  v_position = vec3(u_model * vec4(a_position, 1.0));
  v_normal = transpose(inverse(mat3(u_model))) * a_normal;
  v_texcoord = a_texcoord;
  v_position_light = u_world_to_light * vec4(v_position, 1.0);
  gl_Position = u_projection * u_view * vec4(v_position, 1.0);
}
)";

constexpr const char* sun_shadow = R"(
in vec4 v_position_light;
uniform sampler2D u_map;
uniform vec3 u_to_sun;
vec3 to_light() { return u_to_sun; }

float shadow(vec3 normal) {
  vec3 coordinate = v_position_light.xyz / v_position_light.w * 0.5 + 0.5;
  float bias = max(0.05 * (1.0 - dot(normal, u_to_sun)), 0.005);
  vec2 texel = 1.0 / vec2(textureSize(u_map, 0));
  float sum = 0.0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      sum += coordinate.z - bias > texture(u_map, coordinate.xy + vec2(x, y) * texel).r ? 1.0 : 0.0;
  return coordinate.z > 1.0 ? 0.0 : sum / 9.0;
}
)";

/// A depth texture that is 1, the farthest, beyond its edges.
GlTexture make_map(Gl& gl) {
  GlTexture map(gl);
  gl.BindTexture(GL_TEXTURE_2D, map.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, resolution, resolution, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const float farthest[] = {1, 1, 1, 1};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest);
  return map;
}

class SunDemo : public Demo {
 public:
  explicit SunDemo(Gl& gl)
      : gl_(gl),
        demo_(gl, make_cubes_scene()),
        depth_(build(gl, depth_vertex, "void main() {}\n")),
        colour_(build(gl, lit_vertex, lit_fragment(sun_shadow, false))),
        factor_(build(gl, lit_vertex, lit_fragment(sun_shadow, true))),
        map_(make_map(gl)),
        framebuffer_(gl) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map_.id(), 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    check_gl_error(gl, "making the demo's depth map");
  }

  const Scene& scene() const override { return demo_.scene(); }

  void draw(const Frame& frame, bool shadow_factor) override {
    const glm::mat4 world_to_light =
        glm::ortho(-10.0f, 10.0f, -10.0f, 10.0f, 1.0f, 7.5f) * glm::lookAt(lamp, glm::vec3(0), glm::vec3(0, 1, 0));
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.Viewport(0, 0, resolution, resolution);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.UseProgram(depth_.program.id());
    depth_.uniforms.set("u_world_to_light", world_to_light);
    demo_.draw(gl_, depth_.uniforms);

    begin_picture(gl_, frame, scene());
    Program& program = shadow_factor ? factor_ : colour_;
    set_common(gl_, program, frame, demo_);
    program.uniforms.set("u_world_to_light", world_to_light);
    program.uniforms.set("u_to_sun", -glm::normalize(scene().lights.front().direction));
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, map_.id());
    gl_.ActiveTexture(GL_TEXTURE0);
    demo_.draw(gl_, program.uniforms);
    check_gl_error(gl_, "drawing the demo");
  }

 private:
  Gl& gl_;
  DemoScene demo_;
  Program depth_, colour_, factor_;
  GlTexture map_;
  GlFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Demo> make_sun_demo(Gl& gl) {
  return std::make_unique<SunDemo>(gl);
}

}  // namespace atelier::shadow_demo
