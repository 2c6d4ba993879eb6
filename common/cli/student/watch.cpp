// ./atelier watch: shows a verdict and one thing to fix at every save; keys for everything else.
//
// It stays on its step until the user continues: a student who has passed may want to look around.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "base/file_url.hpp"
#include "base/file_watch.hpp"
#include "base/process.hpp"
#include "cli/commands.hpp"
#include "cli/student/after_pass.hpp"
#include "cli/student/hints.hpp"
#include "cli/student/keyboard.hpp"
#include "cli/student/own_check.hpp"
#include "cli/student/reset_file.hpp"
#include "cli/student/standing.hpp"
#include "grade/environment.hpp"
#include "judge/report/report_terminal.hpp"
#include "judge/report/report_words.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr char ctrl_d = 4;

/// The files that a student may change: those of the step and of the steps that it uses.
std::vector<fs::path> files_to_watch(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                     const CourseStep& step) {
  std::vector<fs::path> files;
  for (const CourseStep& other : course)
    if (other.name == step.name || std::count(step.uses.begin(), step.uses.end(), other.name) > 0)
      for (const std::string& file : other.files) files.push_back(folders.steps() / other.name / file);
  return files;
}

bool is_whole(const fs::path& file) {
  std::error_code error;
  return fs::file_size(file, error) > 0 && !error;
}

enum class Going { on, away };

/// Watching one step.
class Session {
 public:
  Session(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
          const WatchOptions& options, Keyboard& keys)
      : check_(folders, course, step, {.context = options.context, .earlier = options.earlier, .live = options.live}),
        context_(options.context),
        keys_(keys),
        files_(files_to_watch(folders, course, step)),
        style_(judge::terminal_style(STDOUT_FILENO)) {}

  Going run();

 private:
  void wait();
  void listen();
  void settle();
  bool is_obsolete();
  void show_verdict();
  void judge_and_show();
  void explain_keys() const;
  void show_hint();
  void show_all() const;
  void open_report() const;
  void reset();
  std::optional<char> ask(const std::string& question);
  fs::path report() const { return own_report_folder(check_.folders(), check_.step().name); }
  std::vector<Standing> standings_now() const {
    return standings(check_.folders(), check_.course(), read_progress(check_.folders().progress()));
  }

  OwnCheck check_;
  std::string context_;
  Keyboard& keys_;
  FileWatch files_;
  judge::TerminalStyle style_;
  std::deque<char> pressed_;
  bool saved_ = false;  ///< a file has changed since the last verdict was started
  std::optional<judge::SubmissionResult> result_;
};

/// Reads keys and file changes; does not wait.
void Session::listen() {
  while (const auto key = keys_.take()) pressed_.push_back(*key);
  if (!files_.take_changes().empty()) saved_ = true;
}

/// Waits for a key or a change.
void Session::wait() {
  for (listen(); pressed_.empty() && !saved_ && !keys_.closed(); listen()) {
    pollfd inputs[] = {{keys_.descriptor(), POLLIN, 0}, {files_.descriptor(), POLLIN, 0}};  // poll ignores -1
    ::poll(inputs, 2, int(FileWatch::poll_interval.count()));
  }
}

/// An editor may write a file in several steps, or truncate it first: waits until nothing has changed for a moment and
/// no file is empty, with a time limit.
void Session::settle() {
  constexpr milliseconds moment{10}, longest{300};
  const auto until = Clock::now() + longest;
  do {
    saved_ = false;
    std::this_thread::sleep_for(moment);
    listen();
    for (const std::string& file : check_.step().files)
      saved_ = saved_ || !is_whole(check_.folders().steps() / check_.step().name / file);
  } while (saved_ && Clock::now() < until);
  saved_ = false;
}

/// Whether the verdict being computed is obsolete.
bool Session::is_obsolete() {
  listen();
  return saved_ || keys_.closed() || std::any_of(pressed_.begin(), pressed_.end(), [](char key) {
           return key == 'q' || key == ctrl_d || key == 'r' || key == 'n';
         });
}

void Session::explain_keys() const {
  try {
    fmt::print("\n{}\n", progress_line(standings_now(), style_.unicode));
  } catch (const std::exception& error) {
    fmt::print("\nerror: {}\n", error.what());
  }
  fmt::print("[r]un again  [h]int  [l]ist all cases  [o]pen report  [n]ext step  [R]eset a file  [q]uit\n");
  std::fflush(stdout);
}

void Session::judge_and_show() {
  if (style_.colour) fmt::print("\x1b[2J\x1b[H");  // clear the screen for each verdict
  fmt::print("{}: building and drawing ...\n", check_.step().name);
  std::fflush(stdout);
  const auto begin = Clock::now();
  try {
    judge::SubmissionResult result;
    result.submission = "yours";
    result.steps.push_back(check_.judge([this] { return is_obsolete(); }));
    grade::sum_up(result);
    check_.record(result.steps.front());
    result_ = std::move(result);
    show_verdict();
    fmt::print("\n{:.2f} s from the files to the verdict\n",
               std::chrono::duration<double>(Clock::now() - begin).count());
    explain_keys();
    // The slow part comes last; an editor that shows preview.png reloads it.
    result_->environment = grade::describe_environment(context_, check_.folders().step_flags(), check_.folders().root);
    write_own_report(*result_, report());
  } catch (const judge::Interrupted&) {
    fmt::print("(stopped)\n");
  } catch (const std::exception& error) {
    fmt::print("error: {}\n", error.what());
    explain_keys();
  }
  std::fflush(stdout);
}

void Session::show_verdict() {
  const judge::StepResult& step = result_->steps.front();
  fmt::print("\n{}", judge::first_cause_report(step, style_));
  if (grade::all_passed(step)) fmt::print("\n{}", after_pass(check_.folders(), standings_now(), step.step));
}

void Session::show_all() const {
  if (!result_) return fmt::print("There is no verdict yet.\n");
  judge::TerminalStyle style = style_;
  style.table = true;
  fmt::print("\n{}", judge::terminal_report(result_->steps.front(), style));
}

void Session::show_hint() {
  try {
    Hint hint;
    change_progress(check_.folders().progress(),
                    [&](ProgressRecord& record) { hint = next_hint(check_.folders(), check_.step(), "", record); });
    fmt::print("\n{}", hint_text(hint, style_.width));
  } catch (const std::exception& error) {
    fmt::print("{}\n", error.what());
  }
}

void Session::open_report() const {
  const fs::path page = report() / "report.html";
  if (!fs::exists(page)) return fmt::print("There is no report yet.\n");
  fmt::print("{}{}\n", file_url(page), result_ ? judge::place_to_begin(*result_) : "");
#if defined(__APPLE__)
  const char* const opener = "open \"$0\"";
#else
  const char* const opener = "command -v xdg-open && setsid -f xdg-open \"$0\"";
#endif
  const Finished opened =
      run_process({.arguments = {"sh", "-c", fmt::format("({}) >/dev/null 2>&1", opener), page.string()},
                   .time_limit = milliseconds(5000)});
  if (!opened.ok()) fmt::print("No program to open it was found: open the line above in a browser.\n");
}

/// One key as an answer; none if the student quits instead.
std::optional<char> Session::ask(const std::string& question) {
  fmt::print("{} ", question);
  std::fflush(stdout);
  while (pressed_.empty() && !keys_.closed()) {
    pollfd input{keys_.descriptor(), POLLIN, 0};
    ::poll(&input, 1, -1);
    while (const auto key = keys_.take()) pressed_.push_back(*key);
  }
  if (pressed_.empty()) return {};
  const char key = pressed_.front();
  pressed_.pop_front();
  fmt::print("{}\n", key >= ' ' && key <= '~' ? std::string(1, key) : "");
  return key;
}

void Session::reset() {
  const std::vector<std::string>& files = check_.step().files;
  std::size_t chosen = 0;
  if (files.size() > 1) {
    std::string question = "Reset which file?";
    for (std::size_t i = 0; i < files.size(); ++i) question += fmt::format("  [{}] {}", i + 1, files[i]);
    const auto key = ask(question);
    if (!key || *key < '1' || std::size_t(*key - '1') >= files.size()) return fmt::print("Nothing was reset.\n");
    chosen = std::size_t(*key - '1');
  }
  const auto sure =
      ask(fmt::format("{} is reset to its skeleton; a copy of yours is kept. Sure? [y/N]", files[chosen]));
  if (!sure || (*sure != 'y' && *sure != 'Y')) return fmt::print("Nothing was reset.\n");
  const Reset reset = reset_file(check_.folders(), {.step = check_.step(), .name = files[chosen]});
  if (!reset.changed) return fmt::print("{} is already the untouched skeleton.\n", files[chosen]);
  fmt::print("Reset. Your old file is kept in {}\n", reset.copy.string());
}

Going Session::run() {
  judge_and_show();
  for (;;) {
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) return Going::away;  // the output is closed
    wait();
    if (saved_) {
      settle();
      judge_and_show();
      continue;
    }
    if (pressed_.empty()) return Going::away;  // no more keys will come
    const char key = pressed_.front();
    pressed_.pop_front();
    switch (key) {
      case 'r':
      case '\n':
      case '\r':
        judge_and_show();
        break;
      case 'h':
        show_hint();
        break;
      case 'l':
        show_all();
        break;
      case 'o':
        open_report();
        break;
      case 'n':
        return Going::on;
      case 'R':
        try {
          reset();
        } catch (const std::exception& error) {
          fmt::print("error: {}\n", error.what());
        }
        break;
      case 'q':
      case ctrl_d:
        return Going::away;
      default:
        explain_keys();
    }
  }
}

}  // namespace

int run_watch(const WatchOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const auto unfinished = [&]() -> const CourseStep* {
    const auto all = standings(folders, course, read_progress(folders.progress()));
    const Standing* next = next_step(all);
    return next == nullptr ? nullptr : &resolve_step(course, next->step.name);
  };
  const CourseStep* step = options.step.empty() ? unfinished() : &resolve_step(course, options.step);
  if (step == nullptr) {
    fmt::print("Every step has passed. ./atelier watch STEP goes back to one.\n");
    return exit_ok;
  }
  Keyboard keys;
  while (Session(folders, course, *step, options, keys).run() == Going::on) {
    const CourseStep* next = unfinished();
    // If the current step is the first that has not passed, continue with the one after it.
    if (next == step) next = step == &course.back() ? nullptr : step + 1;
    if (next == nullptr) {
      fmt::print("There is no further step.\n");
      break;
    }
    step = next;
  }
  return exit_ok;
}

}  // namespace atelier
