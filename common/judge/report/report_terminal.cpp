#include "judge/report/report_terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "base/columns.hpp"
#include "base/printable.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

constexpr int label_width = 14;  // columns: indentation, longest label and a gap

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

// ---- colour and links

constexpr const char* bold = "1";
constexpr const char* dim = "2";

std::string painted(std::string text, const char* code, const TerminalStyle& style) {
  return style.colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

/// A link that a terminal shows as `words` (OSC 8).
std::string hyperlink(const std::string& url, const std::string& words) {
  return fmt::format("\x1b]8;;{}\x1b\\{}\x1b]8;;\x1b\\", printable(url), words);
}

/// A text as a link to a case in the HTML report.
std::string linked(std::string text, const StepResult& step, const CaseResult& result, const TerminalStyle& style) {
  if (style.report_url.empty()) return text;
  return hyperlink(style.report_url + "#" + case_anchor(step, result, style.steps), text);
}

const char* colour_of(Status status) {
  switch (status) {
    case Status::passed:
      return "32";  // green
    case Status::failed:
      return "31";  // red
    case Status::missing:
      return "33";  // yellow: nothing to judge
    case Status::crashed:
    case Status::timeout:
    case Status::build_failed:
      return "35";  // magenta: a failure of the program, not a wrong answer
  }
  return "0";
}

std::string mark(Status status, const TerminalStyle& style) {
  const bool passed = status == Status::passed;
  const char* const sign = style.unicode ? (passed ? "\u2713" : "\u2717") : (passed ? "+" : "x");
  return painted(sign, colour_of(status), style);
}

// ---- the parts of a report

/// The name of a case, or the number of cases in a group, as a link to the HTML report.
std::string group_name(const StepResult& step, const CaseGroup& group, int width, const TerminalStyle& style) {
  const std::string name = fitted(printable(group.size() > 1 ? cases_words(group.size()) : group.front()->name), width);
  return linked(name, step, *group.front(), style) + std::string(std::size_t(width - columns(name)), ' ');
}

std::string group_score(const CaseGroup& group) {
  const Points sum = sum_of(group);
  return points_text(sum.score) + "/" + points_text(sum.max_score);
}

std::string reason_words(const CaseResult& result) {
  const std::string reason = printable(result.reason);
  return result.status == Status::failed ? reason : status_words(result.status) + (reason.empty() ? "" : ": " + reason);
}

/// One line of the table; without a reason for a pass.
std::string group_line(const StepResult& step, const CaseGroup& group, int name_width, int score_width,
                       const TerminalStyle& style) {
  const CaseResult& first = *group.front();
  const int left = std::max(20, style.width - name_width - score_width - 8);
  const std::string reason = first.status == Status::passed ? "" : "  " + fitted(reason_words(first), left);
  return fmt::format("  {} {}  {:>{}}{}\n", mark(first.status, style), group_name(step, group, name_width, style),
                     group_score(group), score_width, reason);
}

std::string header(const StepResult& step, const TerminalStyle& style) {
  const std::string score = step.max_score > 0 ? score_text(step.score, step.max_score) : "no points in this step";
  std::string text;
  if (!step.caveat.empty()) text = painted(wrapped(printable(step.caveat), style.width, 0), bold, style) + "\n\n";
  text +=
      fmt::format("{}  {}  {}, {} of {} cases passed\n", painted(printable(step.step), bold, style),
                  printable(step.title), painted(score, bold, style), count(step, Status::passed), step.cases.size());
  for (const auto& [of_step, who] : step.implementations)
    text += painted("  with " + printable(of_step) + ": " + printable(who), dim, style) + "\n";
  if (step.references != "stored")
    text += painted("  compared with " + printable(step.references) + " references", dim, style) + "\n";
  return text;
}

/// A line per case.
std::string step_table(const StepResult& step, const TerminalStyle& style) {
  const std::vector<CaseGroup> groups = case_groups(step);
  int name_width = 9, score_width = 3;
  for (const CaseGroup& group : groups) {
    if (group.size() == 1) name_width = std::clamp(columns(printable(group.front()->name)), name_width, 32);
    score_width = std::max(score_width, int(group_score(group).size()));
  }
  std::string text;
  for (const CaseGroup& group : groups) text += group_line(step, group, name_width, score_width, style);
  return text;
}

/// The first lines of a text, and how many are left out.
std::string first_lines(const std::string& text, int most) {
  std::size_t end = 0;
  for (int line = 0; line < most && end != text.npos; ++line) end = text.find('\n', end == 0 ? 0 : end + 1);
  if (end == text.npos || end + 1 >= text.size()) return text;
  return text.substr(0, end + 1) + fmt::format("({} more lines in the report)\n",
                                               std::count(text.begin() + std::ptrdiff_t(end) + 1, text.end(), '\n'));
}

/// What a program, or the compiler, has printed; empty if that is empty.
std::string quoted_output(const char* of_whom, const std::string& output, const TerminalStyle& style) {
  if (output.empty()) return {};
  return painted(fmt::format("  {} output:", of_whom), dim, style) + "\n" +
         indented(printable(output, Layout::keep_lines), style.unicode ? "  \u2502 " : "  | ");
}

std::string explanation(const StepResult& step, std::size_t index, const TerminalStyle& style) {
  constexpr int most_lines = 14;  // of a table, so that the first cause fits a terminal of 40 rows
  const Cause& cause = step.causes[index];
  const CaseResult& shown = shown_case(step, cause);
  std::string text = "\n" + mark(shown.status, style) + " " +
                     linked(painted(printable(headline(step, index)), bold, style), step, shown, style) + "\n";
  for (const Remark& remark : remarks(step, cause)) {
    // Never wrap a command, so that it can be copied, or a compiler's message, so that editors can read it.
    const bool verbatim = remark.label == "rerun" || (remark.label == "found" && shown.status == Status::build_failed);
    const std::string words = printable(remark.text);
    text += painted(padded("  " + remark.label, label_width), dim, style) +
            (verbatim ? words : wrapped(words, style.width - label_width, label_width)) + "\n";
  }
  if (!shown.table.empty() && !shown.unwritten)
    text += indented(first_lines(printable(shown.table, Layout::keep_lines), most_lines), "    ");
  if (style.heat_maps && shown.evidence) text += indented(ascii_heat_map(shown.evidence->over), "    ");
  const bool no_answer = cause.kind == Cause::Kind::no_answer;
  return text + quoted_output("program", no_answer ? output_of(shown_group(step, cause)) : shown.output, style);
}

}  // namespace

bool can_link(int descriptor) {
  return ::isatty(descriptor) == 1 && variable("TERM") != "dumb";
}

TerminalStyle terminal_style(int descriptor) {
  TerminalStyle style;
  style.colour = can_link(descriptor) && variable("NO_COLOR").empty();
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    if (variable(name).empty()) continue;
    const std::string_view locale = variable(name);
    style.unicode = locale.find("UTF-8") != locale.npos || locale.find("utf8") != locale.npos;
    break;  // the first variable that is set decides
  }
  winsize window{};
  if (::ioctl(descriptor, TIOCGWINSZ, &window) == 0 && window.ws_col > 0)
    style.width = std::max<int>(40, window.ws_col);
  return style;
}

std::string terminal_report(const StepResult& step, const TerminalStyle& style) {
  std::string text = header(step, style);
  if (style.table) text += step_table(step, style);
  text += quoted_output("compiler", step.build_log, style);
  for (std::size_t i = 0; i < step.causes.size(); ++i) text += explanation(step, i, style);
  return text;
}

std::string first_cause_report(const StepResult& step, const TerminalStyle& style) {
  constexpr std::size_t most = 5;
  std::string text = header(step, style) + quoted_output("compiler", step.build_log, style);
  if (step.causes.empty()) return text;
  text += explanation(step, 0, style) + (step.causes.size() > 1 ? "\n" : "");
  for (std::size_t i = 1; i < std::min(step.causes.size(), most); ++i) text += printable(headline(step, i)) + "\n";
  if (step.causes.size() > most) text += fmt::format("and {} other things to correct\n", step.causes.size() - most);
  return text;
}

std::string report_link(const std::string& words, const SubmissionResult& result, const TerminalStyle& style) {
  if (style.report_url.empty()) return words;
  return hyperlink(style.report_url + place_to_begin(result), words);
}

std::string terminal_report(const SubmissionResult& result, const TerminalStyle& style) {
  std::string text;
  TerminalStyle of_step = style;
  of_step.steps = steps_in(result);
  for (const StepResult& step : result.steps) text += terminal_report(step, of_step) + "\n";
  for (const std::string& note : result.notes) text += "note: " + printable(note) + "\n";
  int passed = 0;
  std::size_t cases = 0;
  for (const StepResult& step : result.steps) passed += count(step, Status::passed), cases += step.cases.size();
  return text + fmt::format("{}  {}, {} of {} cases passed\n", painted(printable(result.submission), bold, style),
                            painted(score_text(result.score, result.max_score), bold, style), passed, cases);
}

std::string ascii_heat_map(const Image& errors, int columns_wanted) {
  if (errors.empty()) return {};
  constexpr std::string_view signs = " .:-=+*#%@";
  const int width = std::clamp(columns_wanted, 1, errors.width());
  // Characters are about twice as tall as wide.
  const int height = std::clamp(int(double(errors.height()) * width / errors.width() / 2 + 0.5), 1, errors.height());
  std::vector<double> means;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const int x0 = int(std::int64_t(column) * errors.width() / width);
      const int x1 = int(std::int64_t(column + 1) * errors.width() / width);
      const int y0 = int(std::int64_t(row) * errors.height() / height);
      const int y1 = int(std::int64_t(row + 1) * errors.height() / height);
      double sum = 0;
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) sum += std::min(1.0f, std::max(0.0f, errors.at(x, y).r));
      }
      means.push_back(sum / (double(x1 - x0) * (y1 - y0)));
    }
  }
  const double largest = *std::max_element(means.begin(), means.end());
  const std::string edge = "+" + std::string(std::size_t(width), '-') + "+\n";
  std::string text = edge;
  for (int row = 0; row < height; ++row) {
    text += '|';
    for (int column = 0; column < width; ++column) {
      const double mean = means[std::size_t(row) * width + column];
      const int level = mean > 0 ? 1 + int(mean / largest * double(signs.size() - 2)) : 0;
      text += signs[std::size_t(std::min(level, int(signs.size()) - 1))];
    }
    text += "|\n";
  }
  return text + edge;
}

}  // namespace atelier::judge
