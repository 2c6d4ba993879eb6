#include "measure/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"

namespace atelier::measure {
namespace {

// M. Okabe and K. Ito, Color Universal Design, 2008: colours that people with any kind of colour vision can
// distinguish. Without yellow, which is hard to see on white. Each colour has its own mark.
struct Look {
  const char* colour;
  int mark;  ///< gnuplot's point type
};
constexpr std::array<Look, palette_size> palette = {Look{"#0072b2", 7},  Look{"#d55e00", 5},  Look{"#009e73", 9},
                                                    Look{"#cc79a7", 13}, Look{"#56b4e9", 11}, Look{"#e69f00", 4},
                                                    Look{"#000000", 6}};
constexpr const char* ink = "#22262b";
constexpr const char* soft = "#646b74";
constexpr int below_axis = 10;  ///< gnuplot's open triangle pointing down

/// A text in single quotes, in which gnuplot has no escapes but '' for '. Line breaks, which would end the command,
/// become spaces.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out + "'";
}

struct Range {
  double low = 0, high = 0;
  bool has_zeros = false;  ///< values that a logarithmic axis cannot show
};

void include(Range& range, bool& any, double value, Scale scale) {
  if (scale == Scale::logarithmic && value <= 0) {
    range.has_zeros = true;
    return;
  }
  range.low = any ? std::min(range.low, value) : value;
  range.high = any ? std::max(range.high, value) : value;
  any = true;
}

/// The range of an axis with a margin around the values; `decades_in_full`: a logarithmic axis shows whole decades.
Range widened(Range range, bool any, Scale scale, bool decades_in_full) {
  if (scale == Scale::linear) {
    const double width = range.high - range.low;
    const double margin = width > 0 ? 0.05 * width : std::max(1.0, std::abs(range.low)) * 0.5;
    return {range.low - margin, range.high + margin};
  }
  if (!any) return {0.1, 1, range.has_zeros};
  Range decades = range;
  if (!decades_in_full) {
    const double margin = std::pow(std::max(range.high / range.low, 2.0), 0.05);
    decades.low /= margin, decades.high *= margin;
    if (range.has_zeros) decades.low /= 10;
    return decades;
  }
  constexpr double margin = 0.08;  // decades, so that marks on a decade's line are not cut
  decades.low = std::pow(10, std::floor(std::log10(range.low) - margin));
  decades.high = std::pow(10, std::ceil(std::log10(range.high) + margin));
  if (range.has_zeros) decades.low /= 10;
  return decades;
}

Range range_of(const Plot& plot, const Axis& axis, int component) {
  Range range;
  bool any = false;
  const auto take = [&](double value) { include(range, any, value, axis.scale); };
  for (const Curve& curve : plot.curves) {
    for (const glm::dvec2& point : curve.points) take(point[component]);
    if (component == 0)
      for (const glm::dvec2& spread : curve.spread) take(spread.x), take(spread.y);
  }
  for (const Mark& mark : plot.marks) take(mark.at[component]);
  if (component == 1)
    for (const Level& level : plot.levels)
      take(level.below && axis.scale == Scale::logarithmic ? level.y / 2.5 : level.y);  // room for the label
  for (const Tick& tick : axis.ticks) take(tick.at);
  range =
      axis.ticks.empty() ? widened(range, any, axis.scale, component == 1) : Range{range.low - 0.5, range.high + 0.5};
  if (axis.low) range.low = *axis.low;
  if (axis.high) range.high = *axis.high;
  return range;
}

void check(const Plot& plot) {
  const auto refuse = [&](const std::string& why) { throw Error(fmt::format("plot '{}': {}", plot.title, why)); };
  if (std::all_of(plot.curves.begin(), plot.curves.end(), [](const Curve& c) { return c.points.empty(); }))
    refuse("there is nothing to draw");
  const auto finite = [&](double value, const std::string& of) {
    if (!std::isfinite(value)) refuse(fmt::format("{} has a value of {}; only finite values can be drawn", of, value));
  };
  for (const Curve& curve : plot.curves) {
    for (const glm::dvec2& p : curve.points) finite(p.x, "'" + curve.title + "'"), finite(p.y, "'" + curve.title + "'");
    for (const glm::dvec2& s : curve.spread) finite(s.x, "a spread"), finite(s.y, "a spread");
    if (!curve.spread.empty() && curve.spread.size() != curve.points.size())
      refuse(fmt::format("'{}' has {} spreads for {} points", curve.title, curve.spread.size(), curve.points.size()));
  }
  for (const Level& level : plot.levels) finite(level.y, "a level");
  for (const Mark& mark : plot.marks) finite(mark.at.x, "a mark"), finite(mark.at.y, "a mark");
  for (const Axis* axis : {&plot.x, &plot.y})
    for (const auto& end : {axis->low, axis->high})
      if (end && axis->scale == Scale::logarithmic && *end <= 0)
        refuse(fmt::format("the logarithmic axis '{}' ends at {}", axis->label, *end));
}

std::string axis_script(const Axis& axis, const Range& range, char name) {
  std::string script = fmt::format("set {}label {} noenhanced\nset {}range [{:.9g}:{:.9g}]\n", name, quoted(axis.label),
                                   name, range.low, range.high);
  if (!axis.ticks.empty()) {
    script += fmt::format("set {}tics nomirror (", name);
    for (std::size_t i = 0; i < axis.ticks.size(); ++i)
      script += fmt::format("{}{} {:.9g}", i ? ", " : "", quoted(axis.ticks[i].label), axis.ticks[i].at);
    return script + ") noenhanced\n" +
           (axis.scale == Scale::logarithmic ? fmt::format("set logscale {}\n", name) : std::string());
  }
  if (axis.scale == Scale::linear) return script + fmt::format("set {}tics nomirror\n", name);
  // Plain numbers near 1, powers of ten elsewhere.
  const bool plain = range.low >= 0.01 && range.high <= 10'000;
  const int decades = int(std::lround(std::log10(range.high / range.low)));
  script += fmt::format("set logscale {0}\nset format {0} {1}\n", name, plain ? "'%g'" : "'10^{%L}'");
  if (decades > 9) script += fmt::format("set {}tics 100\n", name);
  return script + fmt::format("set {}tics nomirror\nset m{}tics {}\n", name, name, decades > 9 ? 2 : 10);
}

/// The data blocks of one curve. $cN: x, y and both ends of the spread; $zN: the points below a logarithmic axis.
struct CurveData {
  std::string shown, below;
};
CurveData data_of(const Curve& curve, const Plot& plot, const Range& x, const Range& y) {
  CurveData data;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    glm::dvec2 p = curve.points[i];
    const bool under =
        (plot.x.scale == Scale::logarithmic && p.x <= 0) || (plot.y.scale == Scale::logarithmic && p.y <= 0);
    if (plot.x.scale == Scale::logarithmic && p.x <= 0) p.x = x.low;
    if (plot.y.scale == Scale::logarithmic && p.y <= 0) p.y = y.low;
    const glm::dvec2 spread = curve.spread.empty() ? glm::dvec2(p.x) : curve.spread[i];
    (under ? data.below : data.shown) += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", p.x, p.y, spread.x, spread.y);
  }
  return data;
}

const char* drawn_with(Curve::Style style) {
  switch (style) {
    case Curve::Style::marks:
      return "points";
    case Curve::Style::line:
    case Curve::Style::dashes:
      return "lines";
    case Curve::Style::marks_and_line:
      break;
  }
  return "linespoints";
}

/// Adds the elements of the plot command for the curve at index `place`, and their data.
void add_curve(const Plot& plot, std::size_t place, const Range& x, const Range& y, std::string& data,
               std::vector<std::string>& elements) {
  const Curve& curve = plot.curves[place];
  if (curve.points.empty()) return;
  const Look& look = palette[std::size_t(curve.colour < 0 ? int(place) : curve.colour) % palette.size()];
  const CurveData own = data_of(curve, plot, x, y);
  const std::string title = curve.title.empty() ? "notitle" : "title " + quoted(curve.title) + " noenhanced";
  const std::string colour = fmt::format("lc rgb '{}'", look.colour);
  bool named = false;
  if (!own.shown.empty()) {
    data += fmt::format("$c{} << EOD\n{}EOD\n", place, own.shown);
    if (!curve.spread.empty())
      elements.push_back(fmt::format("$c{} using 1:2:3:4 with xerrorbars pt -1 lw 1 {} notitle", place, colour));
    elements.push_back(fmt::format("$c{} using 1:2 with {} lw 2 dt {} pt {} ps 0.9 {} {}", place,
                                   drawn_with(curve.style), curve.style == Curve::Style::dashes ? "'-'" : "1",
                                   look.mark, colour, title));
    named = true;
  }
  if (!own.below.empty()) {
    data += fmt::format("$z{} << EOD\n{}EOD\n", place, own.below);
    elements.push_back(fmt::format("$z{} using 1:2 with points pt {} ps 1.1 lw 2 {} {}", place, below_axis, colour,
                                   named ? "notitle" : title));
  }
}

std::string frame_script(const Plot& plot, const std::string& file) {
  return fmt::format(
      "set terminal svg size {},{} font 'DejaVu Sans,13' background '#ffffff' enhanced\n"
      "set output {}\nset encoding utf8\nset border 3 lc rgb '{}'\n"
      "set grid xtics ytics lt 1 lw 1 lc rgb '#e3e1db'\nset title {} noenhanced font ',14'\n"
      "set key bottom outside center horizontal samplen 2 height 0.8 font ',12'\nset tics textcolor rgb '{}' scale "
      "0.6\n"
      "set rmargin {}\n",
      plot.width, plot.height, quoted(file), soft, quoted(plot.title), ink, plot.x.ticks.empty() ? 3 : 5);
}

/// The line, with its label at the end that is farther from the curves.
std::string level_script(const Plot& plot, const Level& level) {
  const auto far = [&](double y) {
    const bool decades = plot.y.scale == Scale::logarithmic && y > 0 && level.y > 0;
    return decades ? std::abs(std::log(y / level.y)) : std::abs(y - level.y);
  };
  double left = 1e300, right = 1e300;
  for (const Curve& curve : plot.curves) {
    if (curve.points.empty()) continue;
    left = std::min(left, far(curve.points.front().y)), right = std::min(right, far(curve.points.back().y));
  }
  return fmt::format(
      "set arrow from graph 0, first {0:.9g} to graph 1, first {0:.9g} nohead lw 1.5 dt '.' lc rgb '{1}'\n"
      "set label {2} at graph {3}, first {0:.9g} {4} offset 0,{5} noenhanced font ',11' textcolor rgb '{1}'\n",
      level.y, soft, quoted(level.text), left > right ? "0.01" : "0.99", left > right ? "left" : "right",
      level.below ? "-0.6" : "0.6");
}

/// The label of a ring, on the side with more room.
std::string mark_script(const Mark& mark, const Axis& axis, const Range& range) {
  const double along = axis.scale == Scale::logarithmic && mark.at.x > 0
                           ? std::log(mark.at.x / range.low) / std::log(range.high / range.low)
                           : (mark.at.x - range.low) / (range.high - range.low);
  const bool to_left = along > 0.6;
  return fmt::format("set label {} at first {:.9g}, first {:.9g} {} offset {},0.8 noenhanced font ',11' front\n",
                     quoted(mark.text), mark.at.x, mark.at.y, to_left ? "right" : "left", to_left ? "-1.4" : "1.4");
}

}  // namespace

std::string gnuplot_script(const Plot& plot, const std::string& file) {
  check(plot);
  const Range x = range_of(plot, plot.x, 0), y = range_of(plot, plot.y, 1);
  std::string script = frame_script(plot, file) + axis_script(plot.x, x, 'x') + axis_script(plot.y, y, 'y');
  for (const Level& level : plot.levels) script += level_script(plot, level);
  std::string data;
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) add_curve(plot, i, x, y, data, elements);
  std::string ring;
  for (const Mark& mark : plot.marks) {
    ring += fmt::format("{:.9g} {:.9g}\n", mark.at.x, mark.at.y);
    script += mark_script(mark, plot.x, x);
  }
  if (!ring.empty()) {
    data += "$rings << EOD\n" + ring + "EOD\n";
    elements.push_back(fmt::format("$rings using 1:2 with points pt 6 ps 2.2 lw 2 lc rgb '{}' notitle", ink));
  }
  script += data + "plot ";
  for (std::size_t i = 0; i < elements.size(); ++i) script += (i ? ", \\\n     " : "") + elements[i];
  return script + "\n";
}

std::string plot_as_svg(const Plot& plot) {
  const TemporaryFolder folder("atelier-plot");
  const auto script = folder.path() / "plot.gp", picture = folder.path() / "plot.svg";
  write_file(script, gnuplot_script(plot, picture.string()));
  if (!can_plot()) throw Error("gnuplot, which draws the plots, is not installed; ./atelier doctor names its package");
  const Finished finished = run_process({.arguments = {"gnuplot", "-d", script.string()}});
  if (!finished.ok() || !std::filesystem::exists(picture))
    throw Error(fmt::format("gnuplot cannot draw '{}': {}", plot.title, finished.output.substr(0, 500)));
  std::string svg = read_file(picture);
  // The title for screen readers and tooltips.
  const std::string by_default = "<title>Gnuplot</title>";
  if (const auto at = svg.find(by_default); at != std::string::npos) {
    std::string title;
    for (const char c : plot.title)
      title += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
    svg.replace(at, by_default.size(), "<title>" + title + "</title>");
  }
  return svg;
}

bool can_plot() {
  try {
    return run_process({.arguments = {"gnuplot", "--version"}}).ok();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace atelier::measure
