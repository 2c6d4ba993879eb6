#include "grade/results/histogram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/near_names.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

using judge::escape_markup;
using judge::points_text;

constexpr int bar_width = 20, bar_gap = 2, plot_height = 80, above = 14, below = 16;  // in units of the picture

std::string range_words(std::size_t bin) {
  return bin == 10 ? "all points" : fmt::format("{} to {} %", bin * 10, bin * 10 + 10);
}

std::string bar_svg(std::size_t bin, int students, int most) {
  if (students == 0) return {};
  const int x = int(bin) * (bar_width + bar_gap), height = std::max(2, students * plot_height / most);
  const int top = above + plot_height - height;
  return fmt::format(
      "<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}: {}</title></rect>"
      "<text x=\"{}\" y=\"{}\">{}</text>\n",
      bin == 10 ? "all" : "part", x, top, bar_width, height, range_words(bin), students, x + bar_width / 2, top - 3,
      students);
}

std::string bars_in_words(const StepStatistics& step) {
  std::vector<std::string> words;
  for (std::size_t bin = 0; bin < step.bins.size(); ++bin)
    if (step.bins[bin] > 0) words.push_back(fmt::format("{}: {}", range_words(bin), step.bins[bin]));
  return words.empty() ? "nobody" : join(words);
}

std::string plot_svg(const StepStatistics& step) {
  const int most = std::max(1, *std::max_element(step.bins.begin(), step.bins.end()));
  const int width = int(step.bins.size()) * (bar_width + bar_gap) - bar_gap, base = above + plot_height;
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Students by share of the points: {}\">\n",
                  width, base + below, bars_in_words(step));
  for (std::size_t bin = 0; bin < step.bins.size(); ++bin) svg += bar_svg(bin, step.bins[bin], most);
  svg += fmt::format("<line x1=\"0\" y1=\"{0}\" x2=\"{1}\" y2=\"{0}\"/>\n", base, width);
  const int tick = base + below - 3, last = 10 * (bar_width + bar_gap);
  return svg + fmt::format(
                   "<text class=\"first\" x=\"0\" y=\"{0}\">0 %</text><text x=\"{1}\" y=\"{0}\">50 %</text><text "
                   "x=\"{2}\" y=\"{0}\">all</text>\n</svg>\n",
                   tick, last / 2, last + bar_width / 2);
}

}  // namespace

std::string histogram_html(const StepStatistics& step) {
  std::vector<std::string> numbers = {fmt::format("{} handed in", step.handed_in)};
  const auto add = [&](int students, const char* words) {
    if (students > 0) numbers.push_back(fmt::format("{} {}", students, words));
  };
  add(step.not_built, "of these not compiling");
  add(step.untouched, "as in the skeleton");
  add(step.absent, "absent");
  return fmt::format("<article class=\"chart\">\n<h3><span class=\"mono\">{}</span> {}</h3>\n{}",
                     escape_markup(step.step), escape_markup(step.title), plot_svg(step)) +
         fmt::format("<p>median <b>{}</b>, mean <b>{}</b> of {}</p>\n<p class=\"soft\">{}</p>\n</article>\n",
                     points_text(step.median), points_text(step.mean), points_text(step.max_points), join(numbers));
}

}  // namespace atelier::grade
