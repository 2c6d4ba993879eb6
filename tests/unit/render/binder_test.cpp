#include "catch.hpp"
#include "gl/full_screen.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// A program of one pixel, and what it writes there.
struct Pixel {
  Gl& gl;
  GlProgram program;
  Uniforms uniforms;
  Target target;

  Pixel(Gl& context, const std::string& fragment)
      : gl(context),
        program(build_program(context, source(full_screen_vertex_text), source("out vec4 o;\n" + fragment))),
        uniforms(context, program.id()),
        target(context, {.depth = DepthFormat::none}) {
    gl.UseProgram(program.id());
  }
  static ShaderSource source(const std::string& text) {
    return assemble_shader_text([](const std::string&) { return std::filesystem::path(); }, text, "test", {});
  }
  Rgba draw() {
    target.bind(gl);
    draw_triangle_by_id(gl);
    check_gl_error(gl, "drawing a pixel");
    return target.read_colour(gl).at(0, 0);
  }
};

/// A texture of one texel.
GlTexture texel(Gl& gl, glm::vec4 value) {
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, &value.x);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

}  // namespace

TEST_CASE("a binder sets uniforms of every type", "[binder]") {
  const auto context = make_headless_context();
  Pixel pixel(context->gl(), R"(
uniform float f; uniform int i; uniform vec2 v2; uniform vec3 v3; uniform vec4 v4; uniform mat3 m3; uniform mat4 m4;
void main() {
  o = vec4(f == 0.5 && i == -7, v2 == vec2(1.0, 2.0) && v3 == vec3(3.0, 4.0, 5.0),
           v4 == vec4(6.0, 7.0, 8.0, 9.0),
           m3[2][0] == 20.0 && m3[0][2] == 2.0 && m4[3][1] == 31.0 && m4[1][3] == 13.0);
}
)");
  Binder binder(pixel.gl, pixel.uniforms);
  CHECK(pixel.draw() == Rgba{0, 0, 0, 0});  // nothing is set yet
  glm::mat3 m3(0);
  m3[2][0] = 20, m3[0][2] = 2;  // columns first
  glm::mat4 m4(0);
  m4[3][1] = 31, m4[1][3] = 13;
  binder.set("f", 0.5f);
  binder.set("i", -7);
  binder.set("v2", glm::vec2(1, 2));
  binder.set("v3", glm::vec3(3, 4, 5));
  binder.set("v4", glm::vec4(6, 7, 8, 9));
  binder.set("m3", m3);
  binder.set("m4", m4);
  binder.set("nobody_uses_this", 1.0f);
  CHECK(pixel.draw() == Rgba{1, 1, 1, 1});
}

TEST_CASE("a binder assigns texture units in order", "[binder]") {
  const auto context = make_headless_context();
  Gl& gl = context->gl();
  Pixel pixel(gl, R"(
uniform sampler2D first, second;
void main() { o = vec4(texelFetch(first, ivec2(0), 0).r, texelFetch(second, ivec2(0), 0).g, 0.0, 1.0); }
)");
  const GlTexture red = texel(gl, {0.25f, 0, 0, 1}), green = texel(gl, {0, 0.75f, 0, 1});
  const auto bound = [&](GLenum unit) {
    GLint texture = 0;
    gl.ActiveTexture(unit);
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    return GLuint(texture);
  };

  Binder binder(gl, pixel.uniforms);
  binder.texture("first", red.id());
  binder.texture("not_in_the_shader", red.id());  // takes no unit
  binder.texture("second", green.id());
  CHECK(pixel.draw() == Rgba{0.25f, 0.75f, 0, 1});
  CHECK(bound(GL_TEXTURE0) == red.id());
  CHECK(bound(GL_TEXTURE1) == green.id());
  CHECK(bound(GL_TEXTURE2) == 0);

  Binder next(gl, pixel.uniforms);  // a draw later: from the first unit again
  next.texture("first", green.id());
  next.texture("second", green.id());
  CHECK(pixel.draw() == Rgba{0, 0.75f, 0, 1});
  CHECK(bound(GL_TEXTURE2) == 0);
}
