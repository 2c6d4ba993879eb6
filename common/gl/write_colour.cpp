#include "gl/write_colour.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "image/colour.hpp"

namespace atelier {

namespace {

/// One row as glTexSubImage2D needs it: codes for an sRGB texture.
std::vector<Rgba> stored_row(const Image& picture, int y, ColourFormat format) {
  std::vector<Rgba> row(&picture.at(0, y), &picture.at(0, y) + picture.width());
  if (format != ColourFormat::srgb8) return row;
  const auto code = [](float linear) { return float(srgb_code(linear)) / 255; };
  for (Rgba& p : row) p = {code(p.r), code(p.g), code(p.b), p.a};
  return row;
}

}  // namespace

void write_colour(Gl& gl, const Target& target, const Image& picture) {
  const TargetSpec& spec = target.spec();
  if (!target.colour_texture() || spec.samples != 1)
    throw Error(fmt::format("target {}: to write a picture, it needs its own colour texture and one sample per pixel",
                            to_string(spec)));
  if (picture.width() != spec.width || picture.height() != spec.height)
    throw Error(
        fmt::format("target {}: a picture of {}x{} does not fit", to_string(spec), picture.width(), picture.height()));
  gl.BindTexture(GL_TEXTURE_2D, target.colour_texture());
  for (int y = 0; y < spec.height; ++y) {  // OpenGL's first row is the lowest
    const std::vector<Rgba> row = stored_row(picture, y, spec.colour);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, spec.height - 1 - y, spec.width, 1, GL_RGBA, GL_FLOAT, row.data());
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  check_gl_error(gl, "writing a picture into a target");
}

}  // namespace atelier
