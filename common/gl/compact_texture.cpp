#include "gl/compact_texture.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "gl/query.hpp"
#include "image/image.hpp"

namespace atelier {
namespace {

std::uint8_t code_of(float value) {
  return value > 0 ? std::uint8_t(std::min(value, 1.0f) * 255 + 0.5f) : std::uint8_t(0);
}

using Codes = std::array<std::uint8_t, 4>;

Codes codes_of(const Rgba& t, Encoding encoding) {
  if (encoding == Encoding::linear) return {srgb_code(t.r), srgb_code(t.g), srgb_code(t.b), code_of(t.a)};
  return {code_of(t.r), code_of(t.g), code_of(t.b), code_of(t.a)};
}

struct Level {
  GLint width, height;
  std::vector<Rgba> texels;
};

/// All levels of the bound texture, up to GL_TEXTURE_MAX_LEVEL.
std::vector<Level> read_levels(Gl& gl) {
  const GLint highest = texture_parameters(gl, GL_TEXTURE_2D, {GL_TEXTURE_MAX_LEVEL})[0];
  GLint possible = 1;  // querying a higher level is an error
  std::vector<Level> levels;
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  for (GLint level = 0; level < possible && level <= highest; ++level) {
    GLint width = 0, height = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &width);
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT, &height);
    if (width < 1 || height < 1) break;
    if (level == 0) possible = GLint(std::bit_width(unsigned(std::max(width, height))));
    std::vector<Rgba> texels(std::size_t(width) * std::size_t(height));
    gl.GetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_FLOAT, texels.data());
    levels.push_back({width, height, std::move(texels)});
  }
  return levels;
}

/// Reads all levels before `write(number, level)` writes the first: drivers drop the others when level 0 changes its
/// format.
template <class Write>
void rewrite(Gl& gl, GLuint texture, const Write& write) {
  const auto before = GLuint(integer_of(gl, GL_TEXTURE_BINDING_2D));
  check_gl_error(gl, "an earlier call, found before a texture is stored with fewer bits");
  gl.BindTexture(GL_TEXTURE_2D, texture);
  check_gl_error(gl, "binding a texture to be stored with fewer bits");  // else another texture would be converted
  const std::vector<Level> levels = read_levels(gl);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t i = 0; i < levels.size(); ++i) write(GLint(i), levels[i]);
  gl.BindTexture(GL_TEXTURE_2D, before);
  check_gl_error(gl, "storing a texture with fewer bits");
}

}  // namespace

void store_in_8_bits(Gl& gl, GLuint texture, Encoding texels) {
  const GLint format = texels == Encoding::linear ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  rewrite(gl, texture, [&](GLint number, const Level& level) {
    std::vector<Codes> codes(level.texels.size());
    std::transform(level.texels.begin(), level.texels.end(), codes.begin(),
                   [&](const Rgba& t) { return codes_of(t, texels); });
    gl.TexImage2D(GL_TEXTURE_2D, number, format, level.width, level.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, codes.data());
  });
}

void store_in_16_bits(Gl& gl, GLuint texture) {
  rewrite(gl, texture, [&](GLint number, const Level& level) {
    gl.TexImage2D(GL_TEXTURE_2D, number, GL_RGBA16F, level.width, level.height, 0, GL_RGBA, GL_FLOAT,
                  level.texels.data());
  });
}

}  // namespace atelier
