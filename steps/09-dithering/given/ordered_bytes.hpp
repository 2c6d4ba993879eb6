// Ordered dithering of 8-bit codes on the CPU. Given.
#pragma once

#include <cstdint>
#include <span>

namespace atelier {

/// Replaces red, green and blue of each pixel (four bytes, in rows of `width` from the top) by the code of a level: the
/// levels are even in codes, the thresholds are those of a side x side matrix of ranks, row 0 at the top. Shows what
/// level_of and threshold_of make of the same codes. A table for each cell of the matrix has the answer for each code.
/// levels: 2..256.
void dither_bytes(std::span<std::uint8_t> rgba, int width, std::span<const int> ranks, int side, int levels);

}  // namespace atelier
