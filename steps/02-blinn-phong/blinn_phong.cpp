// 02-blinn-phong, the CPU's part: colour, textures, cones and energy. The contract is blinn_phong.hpp.
#include "blinn_phong.hpp"

namespace atelier::blinn_phong {

// ---- Core 1: colour

float srgb_encode(float linear) {
  // TODO(02-blinn-phong): the two branches of the curve
  return linear;
}

float srgb_decode(float encoded) {
  // TODO(02-blinn-phong): the inverse of both branches
  return encoded;
}

// ---- Core 2: textures

std::vector<Image> mipmaps(const Image& base) {
  std::vector<Image> levels = {base};
  // TODO(02-blinn-phong): halve until both sides are 1; average 2x2 pixels, or two where a side is 1 already
  return levels;
}

GLuint upload_texture(Gl& gl, std::span<const Image> levels, Wrap wrap, Filter filter) {
  GLuint texture = 0;
  // TODO(02-blinn-phong): make and bind a texture, upload each level with its last row first, then set filter, wrap and highest level
  return texture;
}

// ---- Core 3: spot lights

glm::vec2 cone_cosines(float inner_angle, float outer_angle) {
  // TODO(02-blinn-phong): two cosines; std::cos of a float near pi need not be exactly -1
  return {1.0f, -1.0f};
}

// ---- Further: materials that keep energy

void balance(glm::vec3& diffuse, glm::vec3& specular) {
  // TODO(02-blinn-phong): one factor for both, from the largest component of their sum
}

// ---- Challenge: a table for the power

std::vector<float> power_table(float exponent, int size) {
  if (size < 2 || !(exponent >= 0.0f)) throw std::invalid_argument("power_table: size at least 2, exponent at least 0");
  std::vector<float> table(std::size_t(size), 0.0f);
  // TODO(02-blinn-phong): x^exponent at evenly spaced x from 0 to 1
  return table;
}

}  // namespace atelier::blinn_phong
