#include "measure/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/base64.hpp"
#include "judge/report/report_assets.hpp"
#include "judge/report/report_words.hpp"
#include "measure/charts.hpp"
#include "measure/expect.hpp"

namespace atelier::measure {
namespace {

using judge::escape_markup;

constexpr std::string_view own_css = R"css(
figure.plot { background: #fff; border: 1px solid var(--line); border-radius: 8px; padding: .5rem; margin: 1rem 0;
  max-width: 46rem; }
figure.plot img { width: 100%; height: auto; display: block; }
table.numbers { table-layout: auto; font-variant-numeric: tabular-nums; font-size: .85rem; }
table.numbers td + td, table.numbers th + th { text-align: right; }
table.numbers th:first-child { width: auto; }
.overflow { overflow-x: auto; }
tr.knee td { font-weight: 650; }
)css";

std::string figure(const Plot& plot) {
  const std::string svg = plot_as_svg(plot);
  return fmt::format(
      "<figure class=\"plot\"><img width=\"{}\" height=\"{}\" alt=\"{}\" "
      "src=\"data:image/svg+xml;base64,{}\"></figure>\n",
      plot.width, plot.height, escape_markup(plot.title), base64(std::as_bytes(std::span(svg.data(), svg.size()))));
}

std::string figure(const std::optional<Plot>& plot) {
  return plot ? figure(*plot) : std::string();
}

std::string number(const std::optional<double>& value, double factor = 1) {
  return value ? fmt::format("{:.4g}", *value * factor) : std::string("&ndash;");
}

std::string count(const Point& point, const char* name) {
  const auto found = point.cost.counts.find(name);
  return found == point.cost.counts.end() ? "&ndash;" : fmt::format("{}", found->second);
}

constexpr const char* counts_shown[] = {"draws", "triangles", "vertices", "variants", "target_bytes", "texture_bytes"};

std::string row(const Point& point, bool is_knee = false) {
  const auto& times = point.cost.times;
  std::string html =
      fmt::format("<tr{}><td>{}</td><td>{:.4g}</td><td>{}</td><td>{}</td>", is_knee ? " class=\"knee\"" : "",
                  escape_markup(point.curve.empty() ? point.value : point.curve + " / " + point.value), point.error,
                  number(point.rmse), number(point.flip));
  html += times ? fmt::format("<td>{:.3f}</td><td>{:.3f} .. {:.3f}</td>", times->median * 1e3, times->least * 1e3,
                              times->most * 1e3)
                : std::string("<td>&ndash;</td><td>&ndash;</td>");
  for (const char* name : counts_shown) html += "<td>" + count(point, name) + "</td>";
  return html + "</tr>\n";
}

std::string table(const std::vector<Point>& points, const std::string& quantity,
                  const std::optional<std::size_t>& knee = {}) {
  std::string html = fmt::format(
      "<details><summary>Numbers</summary><div class=\"overflow\"><table class=\"numbers\"><thead><tr>"
      "<th>value</th><th>{}</th><th>RMSE</th><th>FLIP</th><th>ms, median</th><th>least .. most</th>",
      escape_markup(quantity));
  for (const char* name : counts_shown) html += fmt::format("<th>{}</th>", name);
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < points.size(); ++i) html += row(points[i], knee == i);
  return html + "</tbody></table></div></details>\n";
}

std::string finding_html(const Finding& finding) {
  return fmt::format("<dt class=\"{}\">{}</dt><dd>{}<br><span class=\"soft\">{}</span></dd>\n",
                     finding.met ? "passed" : "failed", finding.met ? "as expected" : "not as expected",
                     escape_markup(finding.words), escape_markup(finding.reason));
}

std::string sweep_html(const SweepResult& sweep) {
  std::string html =
      fmt::format("<section>\n<h2><span>{}</span><span class=\"soft mono\">{}: {}</span></h2>\n",
                  escape_markup(sweep.plan.title), escape_markup(sweep.plan.name), escape_markup(sweep.plan.setting));
  html += figure(chart_of_errors(sweep)) + figure(chart_of_times(sweep)) + "<dl>\n";
  for (const Finding& finding : findings(sweep)) html += finding_html(finding);
  return html + "</dl>\n" + table(sweep.points, quantity_of(sweep.plan)) + "</section>\n";
}

std::string front_html(const FrontResult& front) {
  const Ranking ranking = rank(front);
  std::string html = fmt::format("<section>\n<h2><span>{}</span><span class=\"soft mono\">{}</span></h2>\n",
                                 escape_markup(front.plan.title), escape_markup(front.plan.name));
  html += figure(chart_of_front(front));
  if (ranking.knee)
    html += fmt::format(
        "<p>Recommended default: <b>{}</b>. It is the point of the front farthest below the chord between the fastest "
        "and the most accurate point, on logarithmic axes (after Satop&auml;&auml; and others, <i>Finding a "
        "&ldquo;Kneedle&rdquo; in a Haystack</i>, 2011). More time beyond this point reduces the error little.</p>\n",
        escape_markup(front.points[*ranking.knee].value));
  return html + table(front.points, to_string(front.plan.metric), ranking.knee) + "</section>\n";
}

std::string how_html(const StepMeasured& measured) {
  std::string html =
      "<p class=\"soft\">Errors are against a ground truth computed without the step's code, unless a sweep says "
      "otherwise. A dashed line is the best-fitting power law, by least squares on logarithms, over the points above "
      "three times the curve's smallest error. The dotted line is the noise floor, the smallest error of all curves: "
      "the error that remains at the best value of the setting, from float rounding, the rasteriser's grid of 1/256 "
      "pixel or another approximation. An open triangle is an error of zero. Times are wall-clock times to the end of "
      "glFinish on one machine; compare them only with each other.</p>\n<dl>\n";
  for (const auto& [name, value] : measured.environment)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_markup(name), escape_markup(value));
  return html + "</dl>\n";
}

}  // namespace

std::string page(const StepMeasured& measured) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}: speed and accuracy</title>\n<style>{1}{2}</style>\n</head>\n<body>\n"
      "<header class=\"top\"><h1>{0}: speed and accuracy</h1></header>\n<main>\n",
      escape_markup(measured.step), judge::report_css, own_css);
  html += how_html(measured);
  for (const FrontResult& front : measured.fronts) html += front_html(front);
  for (const SweepResult& sweep : measured.sweeps) html += sweep_html(sweep);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace atelier::measure
