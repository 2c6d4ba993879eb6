// 09-dithering: the contract of dithering.cpp: pictures with few levels, whose means are those of many. You also write
// dithering.glsl, what a pixel shader does; the contract of each function is the comment above it.
//
// A value is 0..1: black to white, in light or in codes, whichever the caller has chosen. L levels stand for the values
// 0, 1/(L-1), 2/(L-1) ... 1, and are numbered from 0. Rows are counted from the top of a picture, columns from the
// left.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace atelier::dithering {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: a matrix of thresholds. You also write `threshold_of` and `level_of` in dithering.glsl.
// ---------------------------------------------------------------------------------------------------------------------

/// Bayer's matrix ("An optimum method for two-level rendition of continuous-tone pictures", 1973) in rows: each rank
/// 0 .. size^2 - 1 once. The matrix of size 1 is 0. That of twice the size holds the smaller one four times, with its
/// ranks times 4, plus 0 in the upper left quarter, 3 in the lower left, 2 in the upper right, 1 in the lower right.
/// size is 2, 4, 8 or 16; throws std::invalid_argument for others. Handout, section 2.
/// Size 2 is 0 2 / 3 1.
std::vector<int> bayer_matrix(int size);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: diffused errors
// ---------------------------------------------------------------------------------------------------------------------

/// How much of a pixel's error a neighbour gets.
struct Share {
  int right = 0;   ///< columns to the right; negative: to the left
  int down = 0;    ///< rows below, at least 0
  float part = 0;  ///< of the error
};

enum class Kernel { floyd_steinberg, atkinson };

/// The shares of a kernel, in any order:
/// - Floyd and Steinberg (1976): right 7/16, below left 3/16, below 5/16, below right 1/16;
/// - Atkinson (Apple, 1984): 1/8 each to the next two on the right, to below left, below and below right, and to the
///   one two rows below. A quarter of the error is lost.
/// Handout, section 3.
std::vector<Share> shares_of(Kernel kernel);

struct Diffusion {
  int levels = 2;                           ///< 2..256
  Kernel kernel = Kernel::floyd_steinberg;  ///< who gets the errors
  bool serpentine = false;                  ///< rows 1, 3, 5 ... run from right to left, and their shares are mirrored
};

/// A level for each value of a picture in rows of `width`. Pixels are visited row by row, from left to right (but see
/// serpentine). Each takes the level next to its value plus the errors that it has received; what this sum has more
/// than the level's value is its error, and goes to the neighbours by the kernel's shares. Shares of neighbours outside
/// the picture go to those inside: all of these are multiplied by one factor, so that their sum is that of all shares
/// (1, or 3/4 for Atkinson). If none is inside, the error is lost. Half way between two levels either is right. Values
/// below 0 count as 0, above 1 as 1, and what is not a number as 0. Handout, section 3. Throws std::invalid_argument if
/// levels is not 2..256, width is below 1, or the last row is not full; no values give no levels. Twice 0.3 in a row, 2
/// levels, floyd_steinberg: level 0 with the error 0.3, all of which goes to the right; 0.6 is level 1.
std::vector<std::uint8_t> diffused(std::span<const float> values, int width, const Diffusion& how);

// Core 3, one bit for each pixel: `cube_place` and `edge_between` in dithering.glsl.

// ---------------------------------------------------------------------------------------------------------------------
// Further: blue noise, a file of bits
// ---------------------------------------------------------------------------------------------------------------------

/// (further) Ranks of a size x size tile in rows, each of 0 .. size^2 - 1 once, by void and cluster (Ulichney 1993).
/// The tile repeats in both directions, so distances are to the nearest copy. Some cells have a point. The energy of a
/// cell is the sum of exp(-d^2 / (2 * 1.5^2)) over all points, d being the distance to each in cells, 0 to its own. The
/// tightest cluster is the cell with a point that has the greatest energy, the largest void the cell without one that
/// has the least.
/// 1. `first` are the cells (row * size + column) that have points at the beginning. The point at the tightest cluster
///    is taken away, and put at the largest void of the pattern without it; and so on, until this is the cell from
///    which it was taken.
/// 2. From the pattern of 1 on, points are taken away, the tightest cluster first. The last one has rank 0, the one
///    before it rank 1, and so on.
/// 3. From the pattern of 1 on, points are added, the largest void first, until all cells have one. Their ranks go on
///    after those of 2.
/// Where energies are equal (in floats: almost equal) either cell is right; step 1 must end also then.
/// size is 4..256; there is at least one point and at most size^2 / 2, no cell twice. Throws std::invalid_argument
/// otherwise. Handout, section 5.
std::vector<int> blue_noise(int size, std::span<const int> first);

/// (further) The bytes of a BMP file with 1 bit a pixel: BITMAPFILEHEADER, BITMAPINFOHEADER (40 bytes; positive height,
/// no compression), two colours, rows. `bits` are the pixels in rows of `width`, from the top: 0 black, anything else
/// white. In the file numbers begin with the least significant byte, rows run from the bottom up, the leftmost pixel is
/// the most significant bit of its byte, and each row is filled with zeros to a multiple of 4 bytes. Colour 0 is black,
/// 1 is white. The numbers of pixels a metre, of bytes of the rows and of colours may be 0, which means that they are
/// not told. Throws std::invalid_argument if width is below 1, there is no pixel, or the last row is not full. Handout,
/// section 6.
std::vector<std::uint8_t> bitmap_file(std::span<const std::uint8_t> bits, int width);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: a pattern on the world (`octave_of`, `surface_place` and `mixed_threshold` in dithering.glsl), and speed
// ---------------------------------------------------------------------------------------------------------------------

/// (challenge) The levels that `diffused` gives for these codes (0 .. 255 for the values 0 .. 1), for
/// Kernel::floyd_steinberg without serpentine, in a fraction of the time. `codes` are pixels of four channels, each of
/// which is a picture of its own; so are the levels. Throws std::invalid_argument if levels is not 2..256, width is
/// below 1, or the last row is not full. Handout, section 8.
std::vector<std::uint8_t> diffused_fast(std::span<const std::uint8_t> codes, int width, int levels);

}  // namespace atelier::dithering
