// ./atelier progress: the student's progress, one line per step.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/student/standing.hpp"
#include "judge/report/report_terminal.hpp"
#include "judge/report/report_words.hpp"

namespace atelier {
namespace {

using OrderedJson = nlohmann::ordered_json;
using judge::points_text;

constexpr int bar_width = 20;

/// The finished fraction of a step, 0..1: by points, or by cases if it has none.
double share_of(const Standing& standing) {
  if (standing.max_score > 0) return standing.score / standing.max_score;
  return standing.cases > 0 ? double(standing.cases_passed) / standing.cases : 0;
}

std::string bar(double share, bool unicode) {
  // Rounded down, so that a full bar means finished.
  const int filled = std::clamp(int(share * bar_width), 0, bar_width);
  std::string text;
  for (int i = 0; i < bar_width; ++i) text += unicode ? (i < filled ? "\u2588" : "\u2591") : (i < filled ? "#" : ".");
  return text;
}

std::string hints_in_words(int hints) {
  return hints == 0 ? "" : hints == 1 ? "  1 hint" : fmt::format("  {} hints", hints);
}

void print_table(const std::vector<Standing>& all, bool unicode) {
  double score = 0, max_score = 0;
  for (const Standing& standing : all) {
    fmt::print("{} {}  {} {:>2} of {:>2} cases{}\n", padded(standing.step.name, 20), bar(share_of(standing), unicode),
               padded(in_words(standing), 24), standing.cases_passed, standing.cases, hints_in_words(standing.hints));
    score += standing.score;
    max_score += standing.max_score;
  }
  fmt::print("{} {}  {}/{} points\n", padded("all steps", 20), bar(max_score > 0 ? score / max_score : 0, unicode),
             points_text(score), points_text(max_score));
  const Standing* next = next_step(all);
  if (next == nullptr)
    fmt::print("\nEvery step has passed in full.\n");
  else
    fmt::print("\nNext: {}  {} (./atelier next)\n", next->step.name, next->step.title);
}

OrderedJson to_json(const std::vector<Standing>& all) {
  OrderedJson steps = OrderedJson::array();
  for (const Standing& standing : all)
    steps.push_back({{"step", standing.step.name},
                     {"title", standing.step.title},
                     {"checked", standing.checked},
                     {"passed", standing.passed},
                     {"edited_since", standing.changed},
                     {"score", standing.score},
                     {"best", standing.best},
                     {"max_score", standing.max_score},
                     {"cases_passed", standing.cases_passed},
                     {"cases", standing.cases},
                     {"hints", standing.hints}});
  const Standing* next = next_step(all);
  return {{"steps", steps}, {"next", next == nullptr ? OrderedJson(nullptr) : OrderedJson(next->step.name)}};
}

}  // namespace

int run_progress(const ProgressOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto all = standings(folders, read_course(folders.step_flags()), read_progress(folders.progress()));
  if (options.json)
    fmt::print("{}\n", to_json(all).dump(2));
  else
    print_table(all, judge::terminal_style(STDOUT_FILENO).unicode);
  return exit_ok;
}

}  // namespace atelier
