#include "scene/card.hpp"

#include <algorithm>
#include <cstdint>

#include "image/colour.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

/// 0..7, by a hash of the place (the finalizer of MurmurHash3, A. Appleby 2011). Of 400 seeds this one keeps the sums
/// of diffused errors farthest from half way between two levels: for 2 to 4 levels by 3.5e-6 of a level, far more than
/// the rounding of floats.
int noise_at(int x, int y, int channel) {
  std::uint32_t h = std::uint32_t(x) + 1000u * std::uint32_t(y) + 1000000u * std::uint32_t(channel) + 10000000u * 146u;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return int((h ^ (h >> 16)) % 8);
}

glm::ivec3 between(const glm::ivec3& a, const glm::ivec3& b, int part, int whole) {
  return a + (b - a) * std::clamp(part, 0, whole) / whole;
}

/// Codes without noise.
glm::ivec3 painted(int x, int y) {
  constexpr int horizon = 72;
  constexpr glm::ivec2 sun(104, 50);
  const auto sky_at = [](int row) {
    return row < 40 ? between({24, 28, 70}, {150, 80, 110}, row, 40)
                    : between({150, 80, 110}, {248, 176, 96}, row - 40, 32);
  };
  const bool sea = y >= horizon;
  const int row = sea ? 2 * horizon - y - 1 : y;
  const int from_sun = (x - sun.x) * (x - sun.x) + (row - sun.y) * (row - sun.y);
  glm::ivec3 colour = sky_at(row);
  if (from_sun < 15 * 15)
    colour = {252, 232, 170};
  else
    colour = between({252, 214, 140}, colour, from_sun - 15 * 15, 1600);
  // Hills on the left: a parabola before another one.
  const int far_hill = 52 + (x - 30) * (x - 30) / 60, near_hill = 58 + (x + 4) * (x + 4) / 70;
  if (row >= near_hill)
    colour = {30, 26, 44};
  else if (row >= far_hill)
    colour = {70, 48, 80};
  if (!sea) return colour;
  const int wave = ((y - horizon) * 3 + x * (y % 3)) % 11;
  return colour * (wave < 5 ? 5 : 7) / 10 + glm::ivec3(4, 10, 22);
}

}  // namespace

Image make_card() {
  Image card(card_size.x, card_size.y);
  for (int y = 0; y < card_size.y; ++y)
    for (int x = 0; x < card_size.x; ++x) {
      const glm::ivec3 paint = painted(x, y);
      const auto light = [&](int channel) {
        return linear_of_code(std::uint8_t(std::clamp(paint[channel] + noise_at(x, y, channel) - 3, 0, 255)));
      };
      card.at(x, y) = {light(0), light(1), light(2), 1};
    }
  return card;
}

Scene make_card_scene() {
  Scene scene{.name = "card"};
  scene.ambient = glm::vec3(1);
  const int picture = add_texture(scene, "picture", make_card(), Filter::nearest, Wrap::clamp_to_edge);
  const int material = add_material(scene, {.name = "card", .diffuse = glm::vec3(1), .diffuse_texture = picture});
  const float width = float(card_size.x) / float(card_size.y);
  add_object(scene, make_plane({.width = width, .depth = 1}), material, upright({.name = "card"}, 0));
  scene.camera = {.eye = {0, 0, 1},
                  .target = {0, 0, 0},
                  .projection = Projection::orthographic,
                  .height = 1,
                  .near = 0.1f,
                  .far = 2};
  return scene;
}

}  // namespace atelier
