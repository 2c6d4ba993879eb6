#include "cli/grader/class_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "cli/grader/class_worker.hpp"
#include "cli/grader/engine.hpp"
#include "grade/results/record.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier {
namespace {

constexpr double redraw_seconds = 0.5;

bool needs_human(const ClassPlaces& places, const std::string& id) {
  try {
    return !grade::read_record(places.record(id)).needs_human.empty();
  } catch (const Error&) {
    return true;
  }
}

}  // namespace

ClassProgress::ClassProgress(const ClassPlaces& places, const ClassPlan& plan)
    : places_(places), plan_(plan), terminal_(judge::can_link(STDERR_FILENO)) {
  at_begin_ = plan.folder.submissions.size() - ungraded(places, plan).size();
  if (!terminal_) last_ = at_begin_;
}

ClassProgress::~ClassProgress() {
  if (terminal_) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

void ClassProgress::show() {
  if (since_shown_.seconds() < redraw_seconds) return;
  since_shown_ = {};
  const std::filesystem::file_time_type written = std::filesystem::last_write_time(places_.plan());
  const std::size_t all = plan_.folder.submissions.size();
  const std::size_t graded = all - ungraded(places_, plan_).size();
  if (graded == last_ || (!terminal_ && graded * 10 / all == last_ * 10 / all)) return;
  std::size_t need_human = 0;
  for (const grade::HandedIn& handed_in : plan_.folder.submissions)
    if (is_graded(places_, handed_in.student.id, written)) need_human += needs_human(places_, handed_in.student.id);
  last_ = graded;
  const std::string line = words(graded, need_human);
  fmt::print(stderr, "{}", terminal_ ? "\r" + line + "\x1b[K" : line + "\n");
  std::fflush(stderr);
}

void ClassProgress::stopped() const {
  const std::size_t all = plan_.folder.submissions.size();
  fmt::print(stderr, "{}stopped: {} of {} are graded; start it again to go on\n", terminal_ ? "\r\x1b[K" : "",
             all - ungraded(places_, plan_).size(), all);
}

std::string ClassProgress::words(std::size_t graded, std::size_t need_human) const {
  const std::size_t all = plan_.folder.submissions.size();
  std::string text = fmt::format("{} of {} graded", graded, all);
  if (need_human > 0) text += fmt::format(", {} need{} a person", need_human, need_human == 1 ? "s" : "");
  if (graded > at_begin_ && graded < all)
    text += fmt::format(", about {} left",
                        duration_words(since_.seconds() / double(graded - at_begin_) * double(all - graded)));
  return text;
}

std::string duration_words(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  const int minutes = int(seconds / 60 + 0.5);
  return minutes < 90 ? fmt::format("{} min", minutes) : fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace atelier
