#include "gl/compact_texture.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "gl/query.hpp"
#include "image/image.hpp"

namespace atelier {
namespace {

using Texel = std::array<std::uint8_t, 4>;

std::uint8_t code_of(float value) {
  return value > 0 ? std::uint8_t(std::min(value, 1.0f) * 255 + 0.5f) : std::uint8_t(0);
}

Texel stored(const Rgba& t, Encoding encoding) {
  if (encoding == Encoding::linear) return {srgb_code(t.r), srgb_code(t.g), srgb_code(t.b), code_of(t.a)};
  return {code_of(t.r), code_of(t.g), code_of(t.b), code_of(t.a)};
}

struct Level {
  GLint width, height;
  std::vector<Texel> texels;
};

/// All levels of the bound texture, up to GL_TEXTURE_MAX_LEVEL.
std::vector<Level> read_levels(Gl& gl, Encoding encoding) {
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
    std::vector<Rgba> floats(std::size_t(width) * std::size_t(height));
    gl.GetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_FLOAT, floats.data());
    std::vector<Texel> texels(floats.size());
    std::transform(floats.begin(), floats.end(), texels.begin(), [&](const Rgba& t) { return stored(t, encoding); });
    levels.push_back({width, height, std::move(texels)});
  }
  return levels;
}

}  // namespace

void store_in_8_bits(Gl& gl, GLuint texture, Encoding texels) {
  const auto before = GLuint(integer_of(gl, GL_TEXTURE_BINDING_2D));
  check_gl_error(gl, "an earlier call, found before a texture is stored in 8 bits");
  gl.BindTexture(GL_TEXTURE_2D, texture);
  check_gl_error(gl, "binding a texture to be stored in 8 bits");  // else another texture would be converted
  // Read all levels before writing: drivers drop the others when level 0 changes its format.
  const std::vector<Level> levels = read_levels(gl, texels);
  const GLint format = texels == Encoding::linear ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t i = 0; i < levels.size(); ++i)
    gl.TexImage2D(GL_TEXTURE_2D, GLint(i), format, levels[i].width, levels[i].height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  levels[i].texels.data());
  gl.BindTexture(GL_TEXTURE_2D, before);
  check_gl_error(gl, "storing a texture in 8 bits");
}

}  // namespace atelier
