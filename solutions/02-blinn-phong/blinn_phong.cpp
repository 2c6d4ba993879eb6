// 02-blinn-phong, the CPU's part: colour, textures, cones and energy. The contract is blinn_phong.hpp.
#include "blinn_phong.hpp"

namespace atelier::blinn_phong {

// ---- Core 1: colour

float srgb_encode(float linear) {
  // >>> student: the two branches of the curve
  const float x = std::max(linear, 0.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  // --- skeleton
  // | return linear;
  // <<< student
}

float srgb_decode(float encoded) {
  // >>> student: the inverse of both branches
  const float x = std::max(encoded, 0.0f);
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  // --- skeleton
  // | return encoded;
  // <<< student
}

// ---- Core 2: textures

std::vector<Image> mipmaps(const Image& base) {
  std::vector<Image> levels = {base};
  // >>> student: halve until both sides are 1; average 2x2 pixels, or two where a side is 1 already
  while (levels.back().width() > 1 || levels.back().height() > 1) {
    const Image& above = levels.back();
    const int step_x = above.width() > 1 ? 1 : 0, step_y = above.height() > 1 ? 1 : 0;
    Image below(std::max(1, above.width() / 2), std::max(1, above.height() / 2));
    for (int y = 0; y < below.height(); ++y)
      for (int x = 0; x < below.width(); ++x) {
        const int left = 2 * x * step_x, top = 2 * y * step_y;
        const Rgba &a = above.at(left, top), &b = above.at(left + step_x, top), &c = above.at(left, top + step_y),
                   &d = above.at(left + step_x, top + step_y);
        below.at(x, y) = {(a.r + b.r + c.r + d.r) / 4, (a.g + b.g + c.g + d.g) / 4, (a.b + b.b + c.b + d.b) / 4,
                          (a.a + b.a + c.a + d.a) / 4};
      }
    levels.push_back(std::move(below));
  }
  // --- skeleton
  // <<< student
  return levels;
}

GLuint upload_texture(Gl& gl, std::span<const Image> levels, Wrap wrap, Filter filter) {
  GLuint texture = 0;
  // >>> student: make and bind a texture, upload each level with its last row first, then set filter, wrap and highest level
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const Image& image = levels[level];
    std::vector<Rgba> turned;
    for (int y = image.height() - 1; y >= 0; --y) turned.insert(turned.end(), &image.at(0, y), &image.at(0, y) + image.width());
    gl.TexImage2D(GL_TEXTURE_2D, GLint(level), GL_RGBA32F, image.width(), image.height(), 0, GL_RGBA, GL_FLOAT, turned.data());
  }
  const GLint enlarge = filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
  const GLint shrink = filter == Filter::mipmap ? GL_LINEAR_MIPMAP_LINEAR : enlarge;
  const GLint mode = wrap == Wrap::repeat ? GL_REPEAT : wrap == Wrap::mirrored_repeat ? GL_MIRRORED_REPEAT : GL_CLAMP_TO_EDGE;
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, enlarge);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shrink);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(levels.size()) - 1);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  // --- skeleton
  // <<< student
  return texture;
}

// ---- Core 3: spot lights

glm::vec2 cone_cosines(float inner_angle, float outer_angle) {
  // >>> student: two cosines; std::cos of a float near pi need not be exactly -1
  const auto cosine = [](float angle) { return angle >= 3.14159265f ? -1.0f : std::cos(angle); };
  return {cosine(inner_angle), cosine(outer_angle)};
  // --- skeleton
  // | return {1.0f, -1.0f};
  // <<< student
}

// ---- Further: materials that keep energy

void balance(glm::vec3& diffuse, glm::vec3& specular) {
  // >>> student: one factor for both, from the largest component of their sum
  const glm::vec3 sum = diffuse + specular;
  const float largest = std::max({sum.r, sum.g, sum.b});
  if (largest <= 1.0f) return;
  diffuse /= largest;
  specular /= largest;
  // --- skeleton
  // <<< student
}

// ---- Challenge: a table for the power

std::vector<float> power_table(float exponent, int size) {
  if (size < 2 || !(exponent >= 0.0f)) throw std::invalid_argument("power_table: size at least 2, exponent at least 0");
  std::vector<float> table(std::size_t(size), 0.0f);
  // >>> student: x^exponent at evenly spaced x from 0 to 1
  for (int i = 0; i < size; ++i) table[std::size_t(i)] = float(std::pow(double(i) / (size - 1), double(exponent)));
  // --- skeleton
  // <<< student
  return table;
}

}  // namespace atelier::blinn_phong
