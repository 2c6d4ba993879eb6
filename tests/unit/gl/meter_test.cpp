// The counts of small frames whose cost is known.
#include <cstdint>
#include <vector>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/objects.hpp"
#include "gl/shader.hpp"
#include "gl/target.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::on_every_context;
using atelier::test::shader_text;

namespace {

/// A program that draws nothing to be seen. What `vertex` and `fragment` read reaches the picture, or a driver would
/// leave it out.
GlProgram program(Gl& gl, const std::string& inputs = "", const std::string& vertex = "vec4(0.0)",
                  const std::string& samplers = "", const std::string& fragment = "vec4(1.0)") {
  return build_program(gl, shader_text(inputs + "void main() { gl_Position = " + vertex + "; }"),
                       shader_text(samplers + "out vec4 o; void main() { o = " + fragment + "; }"));
}

GlTexture texture(Gl& gl, GLenum format, int width, int height) {
  GlTexture made(gl);
  gl.BindTexture(GL_TEXTURE_2D, made.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  return made;
}

/// A vertex array without arrays: what is not fed is a constant.
struct Drawing {
  Gl& gl;
  GlVertexArray corners;
  Target target;
  explicit Drawing(Gl& context) : gl(context), corners(context), target(context, {.width = 4, .height = 2}) {
    gl.BindVertexArray(corners.id());
    target.bind(gl);
    gl.restart_counts();
  }
  void draw(const GlProgram& with) {
    gl.UseProgram(with.id());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
  }
};

}  // namespace

TEST_CASE("attributes count if a shader reads them", "[meter]") {
  on_every_context([](Gl& gl) {
    const std::string all =
        "layout(location = 0) in vec3 a; layout(location = 1) in vec3 b; layout(location = 5) in vec2 c;\n";
    const struct {
      const char* name;
      const char* vertex;
      int attributes;
    } rows[] = {
        {"none", "vec4(0.0)", 0},
        {"the number of the corner, which no buffer feeds", "vec4(float(gl_VertexID))", 0},
        {"one of three", "vec4(a, 1.0)", 1},
        {"two", "vec4(a + b, 1.0)", 2},
        {"three", "vec4(a.xy + c, b.xy)", 3},
    };
    for (const auto& row : rows) {
      INFO(row.name);
      Drawing drawing(gl);
      drawing.draw(program(gl, all, row.vertex));
      CHECK(gl.counts().attributes == row.attributes);
    }
    Drawing drawing(gl);
    drawing.draw(program(gl, all, "vec4(a, 1.0)"));
    drawing.draw(program(gl, all, "vec4(b, 1.0)"));
    drawing.draw(program(gl, all, "vec4(a, 2.0)"));
    CHECK(gl.counts().attributes == 2);  // different ones over all programs
  });
}

TEST_CASE("textures count if a shader samples them", "[meter]") {
  on_every_context([](Gl& gl) {
    const GlTexture red = texture(gl, GL_RGBA8, 4, 4), green = texture(gl, GL_RGBA8, 4, 4);
    const GlProgram blind = program(gl);
    const GlProgram one = program(gl, "", "vec4(0.0)", "uniform sampler2D first;", "texture(first, vec2(0.5))");
    const GlProgram two = program(gl, "", "vec4(0.0)", "uniform sampler2D first, second[2];",
                                  "texture(first, vec2(0.5)) + texture(second[1], vec2(0.5))");
    const auto bind = [&](GLenum unit, const GlTexture& bound) {
      gl.ActiveTexture(unit);
      gl.BindTexture(GL_TEXTURE_2D, bound.id());
    };
    const auto sources = [&](const GlProgram& with, int first, int second) {
      Drawing drawing(gl);
      gl.UseProgram(with.id());
      gl.Uniform1i(gl.GetUniformLocation(with.id(), "first"), first);
      gl.Uniform1i(gl.GetUniformLocation(with.id(), "second[0]"), second);
      gl.Uniform1i(gl.GetUniformLocation(with.id(), "second[1]"), second);
      drawing.draw(with);
      return gl.counts().texture_sources;
    };
    bind(GL_TEXTURE3, green);
    bind(GL_TEXTURE0, red);
    CHECK(sources(blind, 0, 0) == 0);  // bound, and looked up by nobody
    CHECK(sources(one, 0, 0) == 1);
    CHECK(sources(two, 0, 0) == 1);  // the same one twice
    CHECK(sources(two, 0, 3) == 2);
    CHECK(sources(two, 0, 7) == 1);  // nothing is bound there
    CHECK(sources(two, 7, 7) == 0);
  });
}

TEST_CASE("variants are the programs drawn with, switches the changes between them", "[meter]") {
  on_every_context([](Gl& gl) {
    const GlProgram a = program(gl), b = program(gl, "", "vec4(0.5)"), unused = program(gl, "", "vec4(0.25)");
    Drawing drawing(gl);
    for (const GlProgram* each : {&a, &a, &b, &a}) drawing.draw(*each);
    gl.UseProgram(unused.id());
    CHECK(gl.counts().variants == 2);
    CHECK(gl.counts().program_switches == 4);  // to a, b, a, unused
    gl.UseProgram(a.id());
    gl.restart_counts();
    drawing.draw(a);
    CHECK(gl.counts().program_switches == 1);  // a frame is counted by itself, whatever was in use before it
    CHECK(gl.counts().variants == 1);
    CHECK(gl.counts().programs_linked == 0);
  });
}

TEST_CASE("a pass is the drawing between two framebuffer bindings", "[meter]") {
  on_every_context([](Gl& gl) {
    const GlProgram plain = program(gl);
    Drawing drawing(gl);
    const Target other(gl, {.width = 8, .height = 8, .colour = ColourFormat::rgba8, .depth = DepthFormat::none});
    gl.restart_counts();
    CHECK(gl.counts().passes == 0);
    drawing.target.bind(gl);
    CHECK(gl.counts().passes == 0);  // bound, not drawn into
    gl.Clear(GL_COLOR_BUFFER_BIT);
    drawing.draw(plain);
    drawing.draw(plain);
    CHECK(gl.counts().passes == 1);
    CHECK(gl.counts().target_bytes == 4 * 2 * (16 + 4));
    other.bind(gl);
    drawing.draw(plain);
    CHECK(gl.counts().passes == 2);
    CHECK(gl.counts().target_bytes == 4 * 2 * (16 + 4) + 8 * 8 * 4);
    drawing.target.bind(gl);
    drawing.draw(plain);
    CHECK(gl.counts().passes == 3);  // the same target again is another pass, and no more memory
    CHECK(gl.counts().target_bytes == 4 * 2 * (16 + 4) + 8 * 8 * 4);
    drawing.target.read_colour(gl);
    CHECK(gl.counts().passes == 3);

    // The sides of a cube: one framebuffer, one texture, a pass for each side.
    const GlTexture cube(gl);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.id());
    for (GLenum side = 0; side < 6; ++side)
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + side, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const GlFramebuffer framebuffer(gl);
    gl.restart_counts();
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    for (GLenum side = 0; side < 6; ++side) {
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_X + side, cube.id(),
                              0);
      gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    CHECK(gl.counts().passes == 6);
    CHECK(gl.counts().target_bytes == 6 * 16 * 16 * 4);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
}

TEST_CASE("renderbuffers are targets too", "[meter]") {
  on_every_context([](Gl& gl) {
    GlRenderbuffer samples(gl);
    gl.BindRenderbuffer(GL_RENDERBUFFER, samples.id());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 10, 10);
    const GlFramebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples.id());
    gl.restart_counts();
    gl.Clear(GL_COLOR_BUFFER_BIT);
    CHECK(gl.counts().target_bytes == 4 * 10 * 10 * 4);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
}

TEST_CASE("multiple samples per pixel count as memory, resolving them as a pass", "[meter]") {
  on_every_context([](Gl& gl) {
    const TargetSpec spec{.width = 10, .height = 10, .colour = ColourFormat::srgb8, .samples = 4};
    const Target target(gl, spec);
    gl.restart_counts();
    target.bind(gl);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    CHECK(gl.counts().passes == 1);
    CHECK(gl.counts().target_bytes == 4 * 10 * 10 * (4 + 4));
    target.resolve(gl);
    CHECK(gl.counts().passes == 2);
    CHECK(gl.counts().target_bytes == (4 + 1) * 10 * 10 * (4 + 4));
    CHECK(std::size_t(gl.counts().target_bytes) == bytes(spec));
    CHECK(gl.counts().texture_bytes == 0);  // what samples are resolved into is no texture to look up
  });
}

TEST_CASE("texture bytes include all levels and layers, but not targets", "[meter]") {
  on_every_context([](Gl& gl) {
    CHECK(gl.counts().texture_bytes == 0);
    {
      const GlTexture flat = texture(gl, GL_RGBA32F, 5, 3);
      CHECK(gl.counts().texture_bytes == 5 * 3 * 16);
      gl.TexImage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, 2, 1, 0, GL_RGBA, GL_FLOAT, nullptr);
      CHECK(gl.counts().texture_bytes == (5 * 3 + 2) * 16);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);  // instead of the first
      CHECK(gl.counts().texture_bytes == 4 * 4 + 2 * 16);
      gl.restart_counts();
      CHECK(gl.counts().texture_bytes == 4 * 4 + 2 * 16);  // held, whenever it was asked for
      CHECK(gl.counts().allocated_bytes == 0);

      const GlTexture layers(gl);
      gl.BindTexture(GL_TEXTURE_2D_ARRAY, layers.id());
      gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT16, 64, 32, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT,
                    nullptr);
      CHECK(gl.counts().texture_bytes == 4 * 4 + 2 * 16 + 64 * 32 * 4 * 2);
      CHECK(gl.counts().allocated_bytes == 64 * 32 * 4 * 2);
    }
    CHECK(gl.counts().texture_bytes == 0);  // freed

    const Target target(gl, {.width = 16, .height = 16});
    CHECK(gl.counts().texture_bytes == 0);
    const GlTexture chain = texture(gl, GL_RGBA8, 8, 4);
    gl.GenerateMipmap(GL_TEXTURE_2D);
    CHECK(gl.counts().texture_bytes == (8 * 4 + 4 * 2 + 2 * 1 + 1) * 4);
    gl.restart_counts();
    gl.GenerateMipmap(GL_TEXTURE_2D);
    CHECK(gl.counts().allocated_bytes == 0);  // the levels are there
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GenerateMipmap(GL_TEXTURE_2D);
    CHECK(gl.counts().allocated_bytes == (4 * 4 + 2 * 2 + 1) * 4);  // the second level is of another size
  });
}
