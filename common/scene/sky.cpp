#include "scene/sky.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/noise.hpp"
#include "scene/texture_detail.hpp"

namespace atelier {

using texture_detail::ramp;
using texture_detail::require;

namespace {

void check_shape(const SkyShape& shape) {
  require("sky", "clouds", shape.clouds, 0, 1);
  require("sky", "stars", shape.stars, 0, 1);
  for (const SkyDisc& disc : shape.discs) {
    require("sky", "length of a disc's direction", glm::length(glm::dvec3(disc.direction)), 1e-6, 1e6);
    require("sky", "radius of a disc", disc.radius, 0, 0.5);
    require("sky", "halo_width of a disc", disc.halo_width, 0.001, 2);
  }
}

/// The opacity of the clouds, 0..1: noise on a layer overhead that curves down to the horizon, where it fades.
double cloud_opacity(const SkyShape& shape, const glm::dvec3& direction) {
  if (shape.clouds == 0 || direction.y <= 0) return 0;
  const glm::dvec2 on_layer = 2.0 * glm::dvec2(direction.x, direction.z) / (direction.y + 0.2);
  const double least = 0.62 - 0.5 * double(shape.clouds);  // noise is rarely below 0.2 or above 0.8
  const double thickness = ramp(least, least + 0.2, fractal_noise(shape.seed, on_layer, {4096, 4096}, 4));
  return thickness * ramp(0, 0.2, direction.y);
}

/// The light of the star in this direction, if any: at most one in each cell of a grid on the face, and none that
/// crosses the border of its cell.
double star_light(const SkyShape& shape, const glm::dvec3& direction) {
  if (shape.stars == 0) return 0;
  constexpr double cells = 48, radius = 0.25;  // along a face; in cells
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const glm::dvec2 on_face = glm::dvec2(direction[(axis + 1) % 3], direction[(axis + 2) % 3]) / size[axis];
  const glm::dvec2 at = (on_face + 1.0) * (cells / 2), cell = glm::floor(at);
  const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
  const auto number = [&](int which) {
    return hash01(shape.seed + std::uint64_t(8 * face + which + 8), std::int64_t(cell.x), std::int64_t(cell.y));
  };
  if (number(0) >= shape.stars) return 0;
  const glm::dvec2 from_centre = at - cell - (0.3 + 0.4 * glm::dvec2(number(1), number(2)));
  const double inside = std::max(0.0, 1 - glm::dot(from_centre, from_centre) / (radius * radius));
  const double brightness = number(3) * number(3) * number(3);  // many are faint
  return inside * inside * brightness;
}

glm::dvec3 colour_of(const SkyShape& shape, const glm::dvec3& direction) {
  const double down = 1 - std::max(direction.y, 0.0), clear = 1 - cloud_opacity(shape, direction);
  glm::dvec3 colour = glm::mix(glm::dvec3(shape.zenith), glm::dvec3(shape.horizon), down * down * down);
  colour += star_light(shape, direction);
  glm::dvec3 halos(0);
  for (const SkyDisc& disc : shape.discs) {
    const double angle = glm::distance(direction, glm::normalize(glm::dvec3(disc.direction)));
    const double half_texel = 1.0 / shape.edge;
    if (disc.radius > 0)
      colour =
          glm::mix(glm::dvec3(disc.colour), colour, ramp(disc.radius - half_texel, disc.radius + half_texel, angle));
    const double widths = angle / disc.halo_width, falloff = 1 + widths * widths;
    halos += glm::dvec3(disc.halo) / (falloff * falloff);
  }
  colour = glm::mix(glm::dvec3(shape.cloud), colour, clear) + halos;
  return glm::mix(glm::dvec3(shape.ground), colour, ramp(-0.02, 0, direction.y));
}

}  // namespace

glm::dvec3 texel_direction(int face, int column, int row, int edge) {
  const double s = (2 * column + 1.0) / edge - 1, t = (2 * row + 1.0) / edge - 1;
  const std::array<glm::dvec3, 6> on_face = {glm::dvec3(1, -t, -s), {-1, -t, s}, {s, 1, t},
                                             {s, -1, -t},           {s, -t, 1},  {-s, -t, -1}};
  return glm::normalize(on_face.at(std::size_t(face)));
}

Sky make_sky(int edge, const SkyColour& colour) {
  require("sky", "edge", edge, 1, 4096);
  Sky sky;
  for (int face = 0; face < 6; ++face) {
    Image& image = sky.faces[std::size_t(face)] = Image(edge, edge);
    for (int row = 0; row < edge; ++row)
      for (int column = 0; column < edge; ++column) {
        const glm::vec3 c(colour(texel_direction(face, column, row, edge)));
        image.at(column, row) = {c.r, c.g, c.b, 1};
      }
  }
  return sky;
}

Sky make_sky(const SkyShape& shape) {
  check_shape(shape);
  return make_sky(shape.edge, [&](const glm::dvec3& direction) { return colour_of(shape, direction); });
}

}  // namespace atelier
