// Plots of numbers, drawn by gnuplot into SVG: axes with units, curves with marks that need no colour to be told apart.
//
// Text is taken as it is: nothing in it is read as a command or as mark-up. The same plot gives the same bytes with the
// same gnuplot.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace atelier::measure {

enum class Scale { linear, logarithmic };

/// A place on an axis that has a name, for what is no number: a choice, on, off.
struct Tick {
  double at = 0;
  std::string label;
};

struct Axis {
  std::string label;  ///< with the unit: "distance from the origin, m"
  Scale scale = Scale::linear;
  std::optional<double> low, high;  ///< none: just wide enough for what is drawn
  std::vector<Tick> ticks;          ///< empty: round numbers
};

/// Points in the order in which they are joined. On a logarithmic axis a value of zero or less, which has no place, is
/// drawn on the axis' lower end as an open triangle that points down; so no point is lost without a word.
struct Curve {
  enum class Style { marks_and_line, marks, line, dashes };
  std::string title;  ///< in the key; empty: not in it
  std::vector<glm::dvec2> points;
  Style style = Style::marks_and_line;
  int colour = -1;  ///< 0.. of the palette, and so the kind of mark; -1: by its place among the curves
  /// The spread of each point along x (a time's least and most), drawn as a bar; empty: none. As many as points.
  std::vector<glm::dvec2> spread{};
};

/// A horizontal line right across, with its words at the end that is farther from the curves: a noise floor, a bound.
struct Level {
  double y = 0;
  std::string text;
  bool below = false;  ///< the words stand below the line: right where no curve goes below it
};

/// A ring round a point, with words beside it.
struct Mark {
  glm::dvec2 at{0};
  std::string text;
};

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves;
  std::vector<Level> levels{};
  std::vector<Mark> marks{};
  int width = 700, height = 420;  ///< pixels
};

inline constexpr int palette_size = 7;

/// The commands that draw it, into `file`. Throws Error naming the plot where there is nothing to draw, a value is not
/// finite, a spread does not match its points, or an end of a logarithmic axis is not above zero.
std::string gnuplot_script(const Plot& plot, const std::string& file);

/// The picture. Throws as gnuplot_script does, and where gnuplot is missing or refuses.
std::string plot_as_svg(const Plot& plot);

/// Whether gnuplot can be started.
bool can_plot();

}  // namespace atelier::measure
