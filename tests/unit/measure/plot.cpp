// Plots: gnuplot's input, refused input, and the resulting picture.
#include "measure/plot.hpp"

#include "catch.hpp"

namespace atelier::measure {
namespace {

Plot small_plot() {
  return {.title = "Error against size",
          .x = {.label = "pieces", .scale = Scale::logarithmic},
          .y = {.label = "error, m", .scale = Scale::logarithmic},
          .curves = {{.title = "wall", .points = {{4, 1e-1}, {8, 3e-2}, {16, 0}}}},
          .levels = {{.y = 1e-3, .text = "noise floor"}},
          .marks = {{.at = {8, 3e-2}, .text = "knee"}}};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("all options reach gnuplot") {
  const std::string script = gnuplot_script(small_plot(), "out.svg");
  for (const char* part : {"set output 'out.svg'", "set logscale x", "set logscale y", "'pieces'", "'error, m'",
                           "'noise floor'", "'knee'", "title 'wall'", "\n8 0.03 "}) {
    INFO(part);
    CHECK(holds(script, part));
  }
}

TEST_CASE("values outside a logarithmic axis are drawn at its end") {
  const std::string script = gnuplot_script(small_plot(), "out.svg");
  // The smallest value is the level, 1e-3, with its air down to 1e-4; one decade more makes room for zeros.
  CHECK(holds(script, "$z0 << EOD\n16 1e-05 "));
  Plot linear = small_plot();
  linear.y.scale = Scale::linear;
  CHECK_FALSE(holds(gnuplot_script(linear, "out.svg"), "$z0"));
}

TEST_CASE("text is never read as a command") {
  Plot plot = small_plot();
  plot.title = "it's a 'title'\nquit";
  plot.curves[0].title = "a_b^{c}`date`";
  const std::string script = gnuplot_script(plot, "out.svg");
  CHECK(holds(script, "'it''s a ''title'' quit' noenhanced"));
  CHECK(holds(script, "'a_b^{c}`date`' noenhanced"));
  CHECK_FALSE(holds(script, "\nquit"));
}

TEST_CASE("curves differ in mark and in colour") {
  Plot plot = small_plot();
  plot.curves.push_back({.title = "other", .points = {{4, 1}, {8, 1}}});
  const std::string script = gnuplot_script(plot, "out.svg");
  CHECK(holds(script, "pt 7"));
  CHECK(holds(script, "pt 5"));
  CHECK(holds(script, "#0072b2"));
  CHECK(holds(script, "#d55e00"));
}

TEST_CASE("invalid plots are refused with the plot's name") {
  struct Row {
    const char* name;
    void (*spoil)(Plot&);
    const char* words;
  };
  const Row rows[] = {
      {"no curve", [](Plot& p) { p.curves.clear(); }, "nothing to draw"},
      {"no point", [](Plot& p) { p.curves[0].points.clear(); }, "nothing to draw"},
      {"a NaN", [](Plot& p) { p.curves[0].points[1].y = 0.0 / 0.0; }, "'wall' has a value of"},
      {"an infinite level", [](Plot& p) { p.levels[0].y = 1 / 0.0; }, "a level has a value of inf"},
      {"spreads",
       [](Plot& p) {
         p.curves[0].spread = {{1, 2}};
       },
       "1 spreads for 3 points"},
      {"an end of zero", [](Plot& p) { p.x.low = 0; }, "the logarithmic axis 'pieces' ends at 0"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    Plot plot = small_plot();
    row.spoil(plot);
    CHECK(test::mentions(test::error_of([&] { gnuplot_script(plot, "out.svg"); }),
                         {"plot 'Error against size': ", row.words}));
  }
}

TEST_CASE("gnuplot draws the same file twice") {
  if (!can_plot()) SKIP_TEST("gnuplot is not installed");
  Plot plot = small_plot();
  plot.title = "5 < 6 & more";
  const std::string svg = plot_as_svg(plot);
  CHECK(holds(svg, "<svg"));
  CHECK(holds(svg, "<title>5 &lt; 6 &amp; more</title>"));
  CHECK(holds(svg, "noise floor"));
  CHECK(plot_as_svg(plot) == svg);
}

}  // namespace atelier::measure
