// One depth map of 1024 x 1024 texels over a fixed box, everything drawn into it, 3 x 3 comparisons a pixel.
#include <glm/gtc/matrix_transform.hpp>

#include "03-shadow-mapping/given/three_cubes.hpp"
#include "shadow-demo/two_pass_demo.hpp"

namespace atelier::shadow_demo {

namespace {

constexpr glm::vec3 lamp{-2, 4, -1};

constexpr const char* to_light_vertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_model, u_world_to_light;
void main() { gl_Position = u_world_to_light * u_model * vec4(a_position, 1.0); }
)";

constexpr const char* to_map = "  v_position_light = u_world_to_light * vec4(v_position, 1.0);\n";
constexpr const char* to_map_declarations = "uniform mat4 u_world_to_light; out vec4 v_position_light;\n";

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

/// 1, the farthest, beyond its edges.
DepthMap make_flat_map(Gl& gl) {
  DepthMap map{GL_TEXTURE_2D, 1024, GlTexture(gl)};
  gl.BindTexture(GL_TEXTURE_2D, map.texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, map.resolution, map.resolution, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const float farthest[] = {1, 1, 1, 1};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest);
  return map;
}

class SunDemo : public TwoPassDemo {
 public:
  SunDemo(Gl& gl, bool compact_textures)
      : TwoPassDemo(gl, DemoScene(gl, make_cubes_scene(), compact_textures), make_flat_map(gl),
                    demo::build(gl, name, to_light_vertex, "void main() {}\n"), lit_vertex(to_map_declarations, to_map),
                    sun_shadow) {}

 private:
  void set_depth_light(Uniforms& uniforms) override { uniforms.set("u_world_to_light", world_to_light()); }

  void set_light(Uniforms& uniforms) override {
    uniforms.set("u_world_to_light", world_to_light());
    uniforms.set("u_to_sun", -glm::normalize(scene().lights.front().direction));
  }

  static glm::mat4 world_to_light() {
    return glm::ortho(-10.0f, 10.0f, -10.0f, 10.0f, 1.0f, 7.5f) * glm::lookAt(lamp, glm::vec3(0), glm::vec3(0, 1, 0));
  }
};

}  // namespace

std::unique_ptr<Demo> make_sun_demo(Gl& gl, bool compact_textures) {
  return std::make_unique<SunDemo>(gl, compact_textures);
}

}  // namespace atelier::shadow_demo
