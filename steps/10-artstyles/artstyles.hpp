// 10-artstyles: the contract of artstyles.cpp: how a picture is painted, stroke by stroke. You also write
// artstyles.glsl: drawn edges, few greys, lenses; the contract of each function is the comment above it.
//
// Pictures here are pixels of 8 bits a channel, sRGB codes, in rows from the top, up to 10 000 a side. A place is
// (column, row). Random numbers come from given/random.hpp: they depend on the arguments alone, so a still picture is
// painted the same way each time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "10-artstyles/given/random.hpp"

namespace atelier::artstyles {

struct Picture {
  int width = 0, height = 0;
  std::vector<glm::u8vec4> pixels = {};  ///< r, g, b, opacity
};

/// How bright each pixel is.
struct Greys {
  int width = 0, height = 0;
  std::vector<std::uint8_t> values = {};
};

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: strokes
// ---------------------------------------------------------------------------------------------------------------------

/// One centre in each cell of a grid, row by row, from left to right. The first cell begins at (0, 0); cells of cell.x
/// times cell.y pixels cover the whole picture, and those at its right and lower edge may reach beyond it. The centre
/// is a pixel of the cell, each equally likely: with `random` being random_numbers(seed, column, row) of the cell, it
/// is floor(random.x * cell.x / 2^32) columns right of the cell's first pixel, and floor(random.y * cell.y / 2^32) rows
/// below it. Centres outside the picture are left out. No pixels, no centres; throws std::invalid_argument if a side of
/// the picture is negative, or one of a cell is below 1. Handout, section 5.
std::vector<glm::ivec2> stroke_centres(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed);

struct Brush {
  int smallest = 2, largest = 8;  ///< radius, pixels; 0 <= smallest <= largest
  int reach = 4;                  ///< pixels, 0..1000
  float full = 0.5f;              ///< the relative contrast that takes the smallest brush, above 0
};

/// The radius of the brush at `centre`, a pixel of the picture. The relative contrast c is the standard deviation (of
/// all the values, not of a sample of them) divided by the mean of the greys in the square of 2 * reach + 1 pixels a
/// side around the centre, as far as it is inside the picture; c is 0 where all are black. The radius falls evenly from
/// `largest` at c = 0 to `smallest` at c = full, and is `smallest` beyond; it is rounded to the nearest whole number,
/// half way either is right. Handout, section 6.
int brush_radius(const Greys& greys, glm::ivec2 centre, const Brush& brush);

/// One stroke of a round brush along a straight line.
struct Stroke {
  glm::ivec2 from{0}, to{0};  ///< the ends of the line; they may be outside the picture, and the same
  int radius = 0;             ///< pixels, 0..1000
  glm::u8vec4 colour{0};      ///< its opacity is not used
  int opacity = 255;          ///< of the paint, 0..255
  int region = 0;             ///< which part of the picture it may paint
};

/// Rows `first` to `end - 1`.
struct Rows {
  int first = 0, end = 0;
};

/// Paints a stroke on the pixels of the canvas whose centres are at most `radius` away from the line between the
/// centres of the pixels `from` and `to`. Red, green and blue become (opacity * colour + (255 - opacity) * before) /
/// 255, rounded to the nearest whole number; the opacity of a pixel stays. Only the given rows, which are rows of the
/// canvas, are changed or even read: other threads paint the others. If `regions` (a number for each pixel of the
/// canvas) is not empty, only pixels of the stroke's own region and of region 0 are painted. All coordinates are within
/// -10 000 .. 10 000, so everything can be decided in whole numbers, without rounding. Handout, section 7.
/// From (1, 0) to (3, 0) with radius 1: the pixels 0 to 4 of row 0, and 1 to 3 of row 1.
void paint_stroke(Picture& canvas, const Stroke& stroke, Rows rows, std::span<const int> regions);

// ---------------------------------------------------------------------------------------------------------------------
// Further: within the lines
// ---------------------------------------------------------------------------------------------------------------------

/// (further) The regions of a picture, one number for each pixel. A pixel is a border, region 0, if the magnitude of
/// Sobel's gradient of the greys (as in edge_strength, artstyles.glsl, but on whole codes) is above `threshold`, which
/// is at least 0; beyond the edges the picture goes on with the greys of its edges. All other pixels have a number
/// above 0: the same for two of them exactly if a way leads from one to the other over pixels that are no borders, each
/// above, below, left or right of the one before. Pictures are up to 4096 pixels a side. Handout, section 8.
std::vector<int> regions(const Greys& greys, int threshold);

}  // namespace atelier::artstyles
