// OSMesa and EGL use the same driver: their pictures must be the same, bit by bit.
#include <cstring>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/shader.hpp"
#include "gl/target.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::shader_text;

namespace {

/// A shaded triangle with depth, transcendental functions and sloping edges: what drivers like to differ in.
Image triangle(Gl& gl) {
  const GlProgram program = build_program(gl, shader_text(R"(
out vec3 v_weights;
void main() {
  vec2 corners[3] = vec2[](vec2(-0.83, -0.71), vec2(0.91, -0.47), vec2(-0.13, 0.87));
  v_weights = vec3(gl_VertexID == 0, gl_VertexID == 1, gl_VertexID == 2);
  gl_Position = vec4(corners[gl_VertexID], 0.3 * float(gl_VertexID), 1.0 + 0.7 * float(gl_VertexID));
}
)"),
                                          shader_text(R"(
in vec3 v_weights;
out vec4 o_colour;
void main() {
  vec3 n = normalize(v_weights - 0.2);
  o_colour = vec4(pow(abs(n), vec3(2.2)) + 0.1 * sin(40.0 * v_weights), gl_FragCoord.z);
}
)"));
  const GlVertexArray vertices(gl);
  const Target target(gl, {.width = 255, .height = 129});
  target.bind(gl);
  gl.ClearColor(0.1f, 0.2f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.BindVertexArray(vertices.id());
  gl.UseProgram(program.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  return target.read_colour(gl);
}

struct Drawn {
  std::string driver;
  Image picture;
};

Drawn drawn_by(ContextKind kind) {
  const auto context = test::context_if_there(kind);
  return context ? Drawn{context->gl().description(), triangle(context->gl())} : Drawn{};
}

bool same_bits(const Image& a, const Image& b) {
  return a.same_size(b) && std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

}  // namespace

TEST_CASE("OSMesa and EGL draw the same bits, and each draws them again") {
  const Drawn osmesa = drawn_by(ContextKind::osmesa), again = drawn_by(ContextKind::osmesa);
  const Drawn egl = drawn_by(ContextKind::egl);
  if (osmesa.picture.empty() || egl.picture.empty()) SKIP_TEST("both kinds of context are needed");

  int covered = 0;
  for (const Rgba& pixel : osmesa.picture.pixels()) covered += !(pixel == Rgba{0.1f, 0.2f, 0.3f, 1});
  CHECK(covered > 1000);  // there is a triangle
  CHECK(same_bits(osmesa.picture, again.picture));
  if (osmesa.driver != egl.driver)
    SKIP_TEST("EGL reaches another driver here (" + egl.driver + "): its pictures may differ");
  CHECK(same_bits(osmesa.picture, egl.picture));
}
