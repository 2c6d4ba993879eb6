#include "gl/gl.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/objects.hpp"
#include "gl/shader.hpp"
#include "gl/texel.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using atelier::test::on_every_context;
using atelier::test::shader_text;

namespace {

bool names_a_texture(Gl& gl, GLuint id) {
  // A deleted texture's name is free again: core contexts refuse to bind what GenTextures has not handed out.
  gl.BindTexture(GL_TEXTURE_2D, id);
  const bool known = gl.GetError() == GL_NO_ERROR;
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return known;
}

}  // namespace

TEST_CASE("A function that the context lacks is named") {
  const auto none = [](const char*) -> void* { return nullptr; };
  CHECK(mentions(error_of([&] { Gl gl(none); }), {"glActiveTexture", "3.3"}));
}

TEST_CASE("Draws, triangles, programs and clears are counted") {
  on_every_context([](Gl& gl) {
    const GlProgram program = build_program(gl, shader_text("void main() { gl_Position = vec4(0); }"),
                                            shader_text("out vec4 o; void main() { o = vec4(1); }"));
    CHECK(gl.counts().programs_linked == 1);
    const GlVertexArray vertices(gl);
    const GlBuffer indices(gl);
    gl.BindVertexArray(vertices.id());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    const std::vector<std::uint32_t> zeros(9);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(4 * zeros.size()), zeros.data(), GL_STATIC_DRAW);
    const GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 5, 3, 0, GL_RGBA, GL_FLOAT, nullptr);
    const GlFramebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);

    gl.restart_counts();
    gl.UseProgram(program.id());
    gl.Clear(GL_COLOR_BUFFER_BIT);
    const GLfloat black[4] = {};
    gl.ClearBufferfv(GL_COLOR, 0, black);
    struct Row {
      const char* name;
      GLenum mode;
      GLsizei corners;
      int triangles;
    };
    const Row rows[] = {
        {"triangles", GL_TRIANGLES, 9, 3},
        {"a rest that makes no triangle", GL_TRIANGLES, 8, 2},
        {"strip", GL_TRIANGLE_STRIP, 5, 3},
        {"fan", GL_TRIANGLE_FAN, 6, 4},
        {"too short", GL_TRIANGLE_STRIP, 1, 0},
        {"empty", GL_TRIANGLES, 0, 0},
        {"lines", GL_LINES, 8, 0},
    };
    int draws = 0, triangles = 0, corners = 0;
    for (const Row& row : rows) {
      INFO(row.name);
      gl.DrawArrays(row.mode, 0, row.corners);
      gl.DrawElements(row.mode, row.corners, GL_UNSIGNED_INT, nullptr);
      draws += 2, triangles += 2 * row.triangles, corners += 2 * row.corners;
      CHECK(gl.counts().draws == draws);
      CHECK(gl.counts().triangles == triangles);
      CHECK(gl.counts().vertices == corners);
    }
    CHECK(gl.counts().program_switches == 1);
    CHECK(gl.counts().programs_linked == 0);
    CHECK(gl.counts().clears == 2);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
}

TEST_CASE("The sizes of texels are those of their formats") {
  const std::pair<GLenum, int> rows[] = {
      {GL_R8, 1},
      {GL_RG8, 2},
      {GL_RGB8, 4},
      {GL_RGBA8, 4},
      {GL_SRGB8_ALPHA8, 4},
      {GL_R16F, 2},
      {GL_RG16F, 4},
      {GL_RGBA16F, 8},
      {GL_R32F, 4},
      {GL_RG32F, 8},
      {GL_RGBA32F, 16},
      {GL_DEPTH_COMPONENT16, 2},
      {GL_DEPTH_COMPONENT24, 4},
      {GL_DEPTH24_STENCIL8, 4},
      {GL_DEPTH32F_STENCIL8, 8},
  };
  for (const auto& [format, size] : rows) {
    INFO("format 0x" << std::hex << format);
    CHECK(texel_bytes(format) == size);
  }
}

TEST_CASE("OpenGL errors become one named error, and are cleared") {
  on_every_context([](Gl& gl) {
    gl.Enable(0xFFFF);
    CHECK(
        mentions(error_of([&] { check_gl_error(gl, "enabling nonsense"); }), {"GL_INVALID_ENUM", "enabling nonsense"}));
    CHECK_NOTHROW(check_gl_error(gl, "nothing"));
  });
}

TEST_CASE("An object is deleted once, by its last owner") {
  on_every_context([](Gl& gl) {
    GLuint first = 0, second = 0;
    {
      GlTexture a(gl);
      first = a.id();
      gl.BindTexture(GL_TEXTURE_2D, first);  // a name becomes a texture at its first binding
      GlTexture b = std::move(a);
      CHECK_FALSE(a);  // moved from, it holds nothing and deletes nothing
      CHECK(b.id() == first);
      GlTexture c(gl);
      second = c.id();
      gl.BindTexture(GL_TEXTURE_2D, second);
      c = std::move(b);
      CHECK(c.id() == first);
      CHECK(names_a_texture(gl, first));
    }
    CHECK_FALSE(names_a_texture(gl, first));
    CHECK_FALSE(names_a_texture(gl, second));
    CHECK_FALSE(GlBuffer());
  });
}

TEST_CASE("An object made elsewhere can be adopted") {
  on_every_context([](Gl& gl) {
    GLuint made = 0;
    gl.GenTextures(1, &made);
    gl.BindTexture(GL_TEXTURE_2D, made);
    { const GlTexture owner(gl, made); }
    CHECK_FALSE(names_a_texture(gl, made));
  });
}
