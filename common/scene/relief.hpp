// Walls with a relief: matching textures of colour, height and normals, for normal and parallax mapping. Square, row 0
// at the top; the same bits on every machine: see noise.hpp. A parameter out of range throws atelier::Error.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// Three matching textures of one wall.
struct Relief {
  Image colour;  ///< linear light
  Image height;  ///< 0 in the deepest place, 1 in the highest, in red, green and blue
  Image normal;  ///< n/2 + 1/2 in tangent space: red along +u, green along +v (up), blue out of the wall
};

/// A point of a relief.
struct ReliefPoint {
  glm::dvec3 colour;
  double height;  ///< 0..1
};

/// The normal map of a height map, from red of the pixels, in double precision: n = normalize(-dh/du, -dh/dv, 1) by
/// central differences, stored as n/2 + 1/2. `wrap` says what is beyond the edges; mirrored_repeat is the edge's own
/// texel there, as clamp_to_edge. `depth` is the height of 1, where the map is one unit wide and one high.
Image normals_of_heights(const Image& heights, double depth, Wrap wrap);

/// Evaluated at pixel centres, u to the right and v up, both 0..1; it must repeat with period 1. The normals are those
/// of the height map, wrapped around. `depth` is the height of 1, as a fraction of the texture's side; `size` the side
/// in pixels, 1..8192.
Relief make_relief(int size, double depth, const std::function<ReliefPoint(double u, double v)>& point);

/// A brick wall in running bond. Seamless.
struct BrickShape {
  int size = 512;
  int columns = 4, rows = 8;  ///< bricks along a side; rows even, so that the bond tiles; 1..64, 2..64
  float joint = 0.06f;        ///< width of the mortar as a fraction of a brick's height, 0..0.4
  float depth = 0.02f;        ///< of the relief (height 1), as a fraction of the texture's side, 0..0.2
  std::uint64_t seed = 1;
};
Relief make_bricks(const BrickShape& shape = {});

/// Glazed tiles with rounded edges, each slightly tilted in its bed. Seamless.
struct TileShape {
  int size = 512;
  int tiles = 4;         ///< along a side, 1..64
  float joint = 0.05f;   ///< width of the mortar as a fraction of a tile, 0..0.4
  float depth = 0.015f;  ///< as in BrickShape
  std::uint64_t seed = 1;
};
Relief make_tiles(const TileShape& shape = {});

/// Round dimples in a square grid: below the plane by (1 - (r/R)^2)^3 of the depth at distance r < R from the centre of
/// a cell. So the height and its first and second derivatives are known everywhere, and are continuous. Seamless.
struct DimpleShape {
  int size = 256;
  int dimples = 4;       ///< along a side, 1..64
  float radius = 0.45f;  ///< R as a fraction of a cell, 0.01..0.5
  float depth = 0.03f;   ///< as in BrickShape
  glm::vec3 colour{0.55f, 0.5f, 0.45f};
};
Relief make_dimples(const DimpleShape& shape = {});
/// The exact height of `make_dimples`, 0..1, and its slopes (dh/du, dh/dv), both for a depth of 1.
glm::dvec3 dimples_at(const DimpleShape& shape, double u, double v);

/// The word ATELIER carved into a stone slab: strokes with slanted sides. Not symmetric, so that mirroring shows.
struct InscriptionShape {
  int size = 512;
  float stroke = 0.022f;  ///< width of a stroke at the surface as a fraction of the texture's side, 0.005..0.05
  float depth = 0.012f;   ///< as in BrickShape
  std::uint64_t seed = 1;
};
Relief make_inscription(const InscriptionShape& shape = {});

}  // namespace atelier
