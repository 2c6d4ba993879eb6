// Procedural skies, computed texel by texel from the direction of the texel's centre: seamless across the edges of the
// cube. The same bits on every machine: see noise.hpp. A parameter out of range throws atelier::Error.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// The direction of a texel's centre, unit length. `face` is 0..5, `column` and `row` are 0..edge - 1: see Sky.
glm::dvec3 texel_direction(int face, int column, int row, int edge);

/// The linear colour of a direction in world space, unit length.
using SkyColour = std::function<glm::dvec3(const glm::dvec3& direction)>;

/// Any sky: `edge` texels a side, 1..4096.
Sky make_sky(int edge, const SkyColour& colour);

/// The sun or the moon. Angles are measured by the distance of unit directions, which is 1 % smaller at half a radian.
struct SkyDisc {
  glm::vec3 direction{0, 1, 0};  ///< towards its centre, any length except zero
  glm::vec3 colour{1};           ///< linear
  float radius = 0.02f;          ///< radians, 0..0.5; 0: no disc, only its halo. Its edge is as soft as a texel
  glm::vec3 halo{0};             ///< light added at the centre, linear
  float halo_width = 0.1f;       ///< radians from the centre to where a quarter of the halo is left, 0.001..2
};

/// A gradient above a plain ground, discs, clouds and stars. Colours are linear.
struct SkyShape {
  int edge = 256;  ///< texels, 1..4096
  glm::vec3 zenith{0.1f, 0.25f, 0.6f};
  glm::vec3 horizon{0.6f, 0.7f, 0.8f};   ///< its share of the colour is (1 - sine of the elevation)^3
  glm::vec3 ground{0.2f, 0.18f, 0.15f};  ///< below the horizon
  std::vector<SkyDisc> discs;            ///< hidden by the ground and by clouds; halos shine through clouds
  float clouds = 0;                      ///< how much of the sky they cover, roughly; 0: no clouds, 1: few gaps
  glm::vec3 cloud{0.8f};
  float stars = 0;  ///< the share of 48 x 48 places on each face that have a white star, 0..1. Stars are two texels
                    ///< wide where the edge is 256; the brightest has radiance 1
  std::uint64_t seed = 1;  ///< of clouds and stars
};
Sky make_sky(const SkyShape& shape);

}  // namespace atelier
