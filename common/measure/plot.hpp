// Plots as SVG, drawn by gnuplot: axes with units, and curves with different marks, so that colour is not needed to
// distinguish them.
//
// Text is never interpreted as a command or as markup. The same plot gives the same bytes with the same gnuplot.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace atelier::measure {

enum class Scale { linear, logarithmic };

/// A labelled position on an axis, for values that are not numbers: a choice, on, off.
struct Tick {
  double at = 0;
  std::string label;
};

struct Axis {
  std::string label;  ///< with the unit: "distance from the origin, m"
  Scale scale = Scale::linear;
  std::optional<double> low, high;  ///< none: wide enough for all that is drawn
  std::vector<Tick> ticks;          ///< empty: round numbers
};

/// Points in the order in which they are joined. A logarithmic axis cannot show a value of zero or less: it is drawn at
/// the axis' lower end, as an open triangle pointing down.
struct Curve {
  enum class Style { marks_and_line, marks, line, dashes };
  std::string title;  ///< in the legend; empty: not listed
  std::vector<glm::dvec2> points;
  Style style = Style::marks_and_line;
  int colour = -1;  ///< palette index, which also selects the mark; -1: the curve's index
  /// The range of each point along x (smallest and largest time), drawn as a bar. Empty, or one per point.
  std::vector<glm::dvec2> spread{};
};

/// A horizontal line across the plot, such as a noise floor, with its label at the end farther from the curves.
struct Level {
  double y = 0;
  std::string text;
  bool below = false;  ///< puts the label below the line: for a line that no curve goes below
};

/// A ring around a point, with a label.
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

/// The gnuplot commands that draw the plot into `file`. Throws Error naming the plot if there is nothing to draw, a
/// value is not finite, the spreads do not match the points, or a limit of a logarithmic axis is not above zero.
std::string gnuplot_script(const Plot& plot, const std::string& file);

/// The plot as SVG. Throws as gnuplot_script does, and if gnuplot is missing or fails.
std::string plot_as_svg(const Plot& plot);

/// Whether gnuplot can be started.
bool can_plot();

}  // namespace atelier::measure
