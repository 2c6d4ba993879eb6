// A painting from a picture: which strokes, in which order, on how many threads. Given.
#pragma once

#include <functional>

#include "10-artstyles/artstyles.hpp"

namespace atelier {

/// How a picture is painted. The defaults are those of the settings.
struct Painting {
  int iterations = 15;
  int grid = 10;  ///< pixels, about: the cells of each iteration are 3/4 to 5/4 as large
  artstyles::Brush brush{.smallest = 1, .largest = 6, .reach = 4, .full = 0.4f};
  double length = 3;      ///< of the line of a stroke, in radii
  int opacity = 200;      ///< 0..255
  bool confined = false;  ///< strokes stay within the borders of their region
  int border = 150;       ///< the magnitude of Sobel's gradient above which a pixel is a border, codes
  int threads = 1;        ///< changes no pixel
};

/// The student's functions, or others in their place.
struct StrokeFunctions {
  std::function<std::vector<glm::ivec2>(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed)> centres;
  std::function<int(const artstyles::Greys&, glm::ivec2 centre, const artstyles::Brush&)> radius;
  std::function<void(artstyles::Picture&, const artstyles::Stroke&, artstyles::Rows, std::span<const int> regions)>
      paint;
  std::function<std::vector<int>(const artstyles::Greys&, int threshold)> regions;
};
StrokeFunctions student_strokes();
StrokeFunctions fast_strokes();  ///< the student's, but for paint_stroke

/// The luma of the codes, rounded.
artstyles::Greys greys_of(const artstyles::Picture& picture);

/// Paints over the picture: each iteration lays a grid with cells of another size, and paints a stroke at the centre of
/// each cell, in scattered order, in the colour of the picture there. Strokes run along edges: at a right angle to
/// Sobel's gradient, or in any direction where it is 0. Throws Error if a function returns something impossible.
artstyles::Picture painted(const artstyles::Picture& picture, const Painting& how, const StrokeFunctions& functions);

}  // namespace atelier
