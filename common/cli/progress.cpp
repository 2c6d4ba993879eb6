#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/printable.hpp"
#include "judge/report/report_terminal.hpp"
#include "judge/report/report_words.hpp"

namespace atelier {

Progress::Progress(std::FILE* out, bool terminal, int width, std::size_t steps)
    : out_(out), terminal_(terminal), width_(width), steps_(steps) {}

Progress::Progress(std::size_t steps)
    : Progress(stderr, judge::can_link(STDERR_FILENO), judge::terminal_style(STDERR_FILENO).width, steps) {}

void Progress::building(const std::string& step) {
  rewrite(step + ": building");
}

void Progress::judged(const std::string& step, std::size_t k, std::size_t n) {
  rewrite(fmt::format("{}: case {} of {}", step, k, n));
}

void Progress::finished(const judge::StepResult& step) {
  if (!terminal_)
    fmt::print(out_, "{}\n",
               with_place(fmt::format("{}: {}, {} of {} cases passed", step.step,
                                      judge::score_text(step.score, step.max_score),
                                      judge::count(step, judge::Status::passed), step.cases.size())));
  std::fflush(out_);
  ++place_;
}

void Progress::clear() {
  if (!terminal_) return;
  fmt::print(out_, "\r\x1b[K");
  std::fflush(out_);
}

void Progress::rewrite(const std::string& text) {
  if (!terminal_) return;
  // Leave the last column free: a wrapped line could not be overwritten.
  fmt::print(out_, "\r{}\x1b[K", shorten(with_place(text), std::size_t(width_ - 1)));
  std::fflush(out_);
}

std::string Progress::with_place(const std::string& text) const {
  return fmt::format("{} (step {} of {})", text, place_, steps_);
}

}  // namespace atelier
