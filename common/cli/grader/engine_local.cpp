#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <map>
#include <memory>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/launch.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "cli/grader/class_worker.hpp"
#include "cli/grader/engine.hpp"
#include "judge/run/runner.hpp"
#include "judge/run/worker.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr int poll_ms = 100;
constexpr int most_ends = 2;  ///< on one submission

/// One process, and its last words.
struct Hand {
  std::unique_ptr<judge::Worker> process;
  std::string output;
};

class LocalEngine {
 public:
  LocalEngine(const EngineSettings& settings, const ClassPlan& plan) : settings_(settings), plan_(plan) {}

  void run() {
    const std::size_t count = std::min(std::size_t(settings_.workers), ungraded(settings_.places, plan_).size());
    hands_.resize(count);
    for (std::size_t i = 0; i < count; ++i) start(int(i));
    while (std::ranges::any_of(hands_, [](const Hand& hand) { return hand.process != nullptr; })) {
      if (settings_.interrupted && settings_.interrupted()) throw judge::Interrupted();
      if (settings_.waiting) settings_.waiting();
      ::poll(nullptr, 0, poll_ms);
      for (std::size_t i = 0; i < count; ++i) look_at(int(i));
    }
  }

 private:
  void start(int index) {
    std::error_code none;
    fs::remove(settings_.places.at_work(index), none);
    Hand& hand = hands_[std::size_t(index)];
    hand.output.clear();
    hand.process = std::make_unique<judge::Worker>(
        Launch{.arguments = worker_command(settings_.places, std::to_string(index), int(hands_.size())),
               .folder = {},
               .environment = own_environment(),
               .descriptors = {}});
  }

  void look_at(int index) {
    Hand& hand = hands_[std::size_t(index)];
    if (!hand.process) return;
    const std::optional<judge::Exit> exit = hand.process->ended();
    hand.output += hand.process->take_output();
    hand.output.erase(0, hand.output.size() - std::min<std::size_t>(hand.output.size(), 4096));
    if (!exit) return;
    hand.process.reset();
    if (exit->signal == 0 && exit->status == exit_ok) return;
    blame(index, exit->signal != 0 ? signal_name(exit->signal) : last_line(hand.output));
    start(index);
  }

  /// A process has ended before its work was done: because of the submission that it had, if it had one.
  void blame(int index, const std::string& why) {
    std::error_code none;
    const fs::path at_work = settings_.places.at_work(index);
    if (!fs::exists(at_work, none)) throw Error(why);
    const std::string id = read_file(at_work);
    if (++ends_[id] < most_ends) return;
    for (const grade::HandedIn& handed_in : plan_.folder.submissions)
      if (handed_in.student.id == id)
        record_failure(settings_.places, plan_, handed_in,
                       fmt::format("The grader itself has ended {} times on it: {}", most_ends, why));
  }

  static std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::string line = text.substr(text.rfind('\n') + 1);
    return shorten(printable(line.starts_with("error: ") ? line.substr(7) : line), 500);
  }

  const EngineSettings& settings_;
  const ClassPlan& plan_;
  std::vector<Hand> hands_;
  std::map<std::string, int> ends_;  ///< by id
};

}  // namespace

std::vector<const grade::HandedIn*> ungraded(const ClassPlaces& places, const ClassPlan& plan) {
  const fs::file_time_type written = fs::last_write_time(places.plan());
  std::vector<const grade::HandedIn*> left;
  for (const grade::HandedIn& handed_in : plan.folder.submissions)
    if (!is_graded(places, handed_in.student.id, written)) left.push_back(&handed_in);
  return left;
}

std::vector<std::string> worker_command(const ClassPlaces& places, const std::string& index, int of) {
  return {fs::read_symlink("/proc/self/exe").string(),
          "grade-worker",
          places.out.string(),
          "--index",
          index,
          "--of",
          std::to_string(of)};
}

void run_local_engine(const EngineSettings& settings, const ClassPlan& plan) {
  LocalEngine(settings, plan).run();
}

}  // namespace atelier
