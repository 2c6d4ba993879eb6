#include "gl/compact_texture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/full_screen.hpp"
#include "gl/objects.hpp"
#include "gl/query.hpp"
#include "gl/shader.hpp"
#include "gl/target.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using atelier::test::on_every_context;
using atelier::test::shader_text;

namespace {

/// A texture of floats with levels of these sizes, which is left unbound; texel i of n has (i / n, 0.25, 2, i / n).
GlTexture floats(Gl& gl, const std::vector<glm::ivec2>& sizes) {
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  for (std::size_t level = 0; level < sizes.size(); ++level) {
    const std::size_t count = std::size_t(sizes[level].x * sizes[level].y);
    std::vector<Rgba> texels(count);
    for (std::size_t i = 0; i < count; ++i) texels[i] = {float(i) / float(count), 0.25f, 2, float(i) / float(count)};
    gl.TexImage2D(GL_TEXTURE_2D, GLint(level), GL_RGBA32F, sizes[level].x, sizes[level].y, 0, GL_RGBA, GL_FLOAT,
                  texels.data());
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(sizes.size()) - 1);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

/// What a shader is given of one level, row by row as OpenGL has them.
Image fetched(Gl& gl, const GlTexture& texture, GLint level, glm::ivec2 size) {
  const GlProgram program =
      build_program(gl, shader_text(full_screen_vertex_text),
                    shader_text("uniform sampler2D u_texture; uniform int u_level; out vec4 o;\n"
                                "void main() { o = texelFetch(u_texture, ivec2(gl_FragCoord.xy), u_level); }"));
  const Target target(gl, {.width = size.x, .height = size.y, .depth = DepthFormat::none});
  target.bind(gl);
  gl.UseProgram(program.id());
  gl.Uniform1i(gl.GetUniformLocation(program.id(), "u_level"), level);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  draw_triangle_by_id(gl);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return target.read_colour(gl);
}

/// The largest difference over all texels of a level, in codes of 255: of sRGB codes where the texels were light.
double codes_apart(const Image& a, const Image& b, Encoding encoding) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    const bool light = encoding == Encoding::linear;
    const Rgba x = light ? srgb_encode(p) : p, y = light ? srgb_encode(q) : q;
    for (const float difference : {x.r - y.r, x.g - y.g, x.a - y.a})
      most = std::max(most, 255.0 * std::abs(difference));
  }
  return most;
}

}  // namespace

TEST_CASE("every level of a compact texture keeps its texels, up to rounding to 8 bits", "[compact_texture]") {
  const std::vector<glm::ivec2> sizes = {
      {37, 21}, {18, 10}, {9, 5}, {4, 2}};  // not down to 1x1: the highest level is 3
  on_every_context([&](Gl& gl) {
    for (const Encoding encoding : {Encoding::linear, Encoding::srgb, Encoding::data}) {
      INFO("encoding " << int(encoding));
      const GlTexture before = floats(gl, sizes), texture = floats(gl, sizes);
      gl.restart_counts();
      store_in_8_bits(gl, texture.id(), encoding);
      for (std::size_t level = 0; level < sizes.size(); ++level) {
        INFO("level " << level);
        const Image expected = fetched(gl, before, GLint(level), sizes[level]),
                    seen = fetched(gl, texture, GLint(level), sizes[level]);
        CHECK(seen.at(0, 0).b == 1);  // 2 is cut off
        const double apart = codes_apart(seen, expected, encoding);
        // Half a code by rounding. A sampler may decode sRGB wrongly by as much: so Direct3D's specification has it,
        // which drivers are built for.
        CHECK(apart <= (encoding == Encoding::linear ? 1.0 : 0.5 + 1e-3));
        CHECK(apart > 0.2);  // and it is no float any more
      }
    }
  });
}

TEST_CASE("floats of 16 bits keep eleven binary digits and half of the memory", "[compact_texture]") {
  const std::vector<glm::ivec2> sizes = {{8, 4}, {4, 2}};
  on_every_context([&](Gl& gl) {
    const GlTexture before = floats(gl, sizes), texture = floats(gl, sizes);
    const std::int64_t one = gl.counts().texture_bytes / 2;
    store_in_16_bits(gl, texture.id());
    CHECK(gl.counts().texture_bytes == one + one / 2);
    for (std::size_t level = 0; level < sizes.size(); ++level) {
      const Image expected = fetched(gl, before, GLint(level), sizes[level]),
                  seen = fetched(gl, texture, GLint(level), sizes[level]);
      for (std::size_t i = 0; i < seen.pixels().size(); ++i) {
        CHECK(seen.pixels()[i].b == expected.pixels()[i].b);  // 2 is not cut off
        CHECK(seen.pixels()[i].r == Approx(expected.pixels()[i].r).epsilon(0x1p-10));
      }
    }
  });
}

TEST_CASE("making a texture compact keeps its parameters and the bindings", "[compact_texture]") {
  on_every_context([](Gl& gl) {
    const GlTexture texture = floats(gl, {{8, 4}, {4, 2}, {2, 1}, {1, 1}}), bound = floats(gl, {{1, 1}});
    const std::int64_t other = 16, held = gl.counts().texture_bytes - other;
    gl.BindTexture(GL_TEXTURE_2D, bound.id());
    store_in_8_bits(gl, texture.id(), Encoding::linear);
    CHECK(GLuint(integer_of(gl, GL_TEXTURE_BINDING_2D)) == bound.id());
    CHECK(gl.counts().texture_bytes - other == held / 4);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    CHECK(level_parameters(gl, GL_TEXTURE_2D, {GL_TEXTURE_INTERNAL_FORMAT}) == std::vector<GLint>{GL_SRGB8_ALPHA8});
    CHECK(texture_parameters(gl, GL_TEXTURE_2D,
                             {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
                              GL_TEXTURE_MAX_LEVEL}) ==
          std::vector<GLint>{GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST, GL_MIRRORED_REPEAT, GL_REPEAT, 3});
    gl.BindTexture(GL_TEXTURE_2D, 0);
  });
}

TEST_CASE("anything but a 2D texture is refused or not changed", "[compact_texture]") {
  on_every_context([](Gl& gl) {
    store_in_8_bits(gl, 0, Encoding::linear);  // upload_texture is not written yet
    const GlTexture empty(gl);
    store_in_8_bits(gl, empty.id(), Encoding::linear);
    const GlTexture bound = floats(gl, {{2, 2}}), cube(gl);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.id());
    gl.BindTexture(GL_TEXTURE_2D, bound.id());
    CHECK(mentions(error_of([&] { store_in_8_bits(gl, cube.id(), Encoding::linear); }),
                   {"GL_INVALID_OPERATION", "stored with fewer bits"}));
    CHECK(level_parameters(gl, GL_TEXTURE_2D, {GL_TEXTURE_INTERNAL_FORMAT}) == std::vector<GLint>{GL_RGBA32F});

    const GlTexture strange(gl);  // a student may leave the highest level at its 1000, and texels that are no numbers
    gl.BindTexture(GL_TEXTURE_2D, strange.id());
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const Rgba texel{nan, infinity, -infinity, -1};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, &texel);
    store_in_8_bits(gl, strange.id(), Encoding::srgb);
    CHECK(fetched(gl, strange, 0, {1, 1}).at(0, 0) == Rgba{0, 1, 0, 0});
  });
}
