// Procedural textures in linear light, row 0 at the top. Each tiles seamlessly and gives the same bits on every
// machine: see noise.hpp. Sides are 1..8192 pixels; a parameter out of range throws atelier::Error.
#pragma once

#include <cstdint>

#include "image/image.hpp"

namespace atelier {

/// Two alternating colours. The square at the lower left corner has the first.
struct CheckerTexture {
  int size = 256;   ///< pixels a side
  int squares = 8;  ///< along a side, 1..size
  Rgba first{0.8f, 0.8f, 0.8f}, second{0.1f, 0.1f, 0.1f};
};
Image make_checker(const CheckerTexture& texture = {});

/// A texture that shows its orientation: red increases with u and green with v, thin lines mark tenths, a frame marks
/// the border (white at the top, black at the bottom, cyan on the left, magenta on the right), and a white arrow points
/// up, towards larger v. Makes mirroring, rotation and cropping visible.
Image make_uv_grid(int size = 512);

/// Round dots in rows, each shifted by half a step against the next.
struct DotsTexture {
  int size = 256;
  int dots = 4;         ///< along a side; even, so that the shifted rows tile; 2..256
  float radius = 0.3f;  ///< as a fraction of the dot spacing, 0.01..0.5
  Rgba dot{0.75f, 0.12f, 0.08f}, ground{0.85f, 0.8f, 0.7f};
};
Image make_dots(const DotsTexture& texture = {});

/// Boards: annual rings cut lengthwise, stretched along u.
struct WoodTexture {
  int size = 512;
  int boards = 4;  ///< side by side along v, 1..64
  std::uint64_t seed = 1;
};
Image make_wood(const WoodTexture& texture = {});

/// White stone with veins: bands bent by noise (Perlin, "An image synthesizer", 1985), with a triangle wave instead of
/// his sine.
struct MarbleTexture {
  int size = 512;
  int bands = 4;            ///< along a side, 1..64
  float turbulence = 1.5f;  ///< distortion by noise, in bands, 0..8
  std::uint64_t seed = 1;
};
Image make_marble(const MarbleTexture& texture = {});

}  // namespace atelier
