#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <memory>
#include <system_error>

#include "base/error.hpp"
#include "base/launch.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "cli/commands.hpp"
#include "cli/grader/engine.hpp"
#include "judge/run/runner.hpp"
#include "judge/run/worker.hpp"
#include "sandbox/control_group.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr int poll_ms = 100;
constexpr int most_idle_ends = 5;  ///< of processes without a submission, one after the other

/// One process, and its last words.
struct Hand {
  std::unique_ptr<judge::Worker> process;
  std::string output;
};

class LocalEngine {
 public:
  LocalEngine(const EngineSettings& settings, const ClassPlan& plan)
      : settings_(settings), plan_(plan), ends_(settings.places, plan) {}

  ~LocalEngine() {
    hands_.clear();  // kills them, if this was interrupted
    sandbox::ControlGroup::remove_abandoned();
  }

  void run() {
    const std::size_t count = std::min(std::size_t(settings_.workers), left());
    hands_.resize(count);
    for (std::size_t i = 0; i < count; ++i) start(int(i));
    while (is_working()) {
      if (settings_.interrupted && settings_.interrupted()) throw judge::Interrupted();
      if (settings_.waiting) settings_.waiting();
      ::poll(nullptr, 0, poll_ms);
      for (std::size_t i = 0; i < count; ++i) look_at(int(i));
      // All have ended well, but another process held the folder of a submission, such as one that is being killed.
      if (!is_working() && left() > 0) {
        count_idle_end(fmt::format("another process has locked a folder in {}", settings_.places.out.string()));
        start(0);
      }
    }
  }

 private:
  bool is_working() const {
    return std::ranges::any_of(hands_, [](const Hand& hand) { return hand.process != nullptr; });
  }

  std::size_t left() const { return ungraded(settings_.places, plan_).size(); }

  void start(int index) {
    std::error_code none;
    fs::remove(settings_.places.at_work(index), none);
    Hand& hand = hands_[std::size_t(index)];
    hand.output.clear();
    std::map<std::string, std::string> environment = own_environment();
    environment["TMPDIR"] = settings_.temporary.empty_folder(fmt::format("worker-{}", index)).string();
    hand.process = std::make_unique<judge::Worker>(
        Launch{.arguments = worker_command(settings_.places, std::to_string(index), int(hands_.size())),
               .folder = {},
               .environment = std::move(environment),
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
    const std::string why = exit->signal != 0 ? signal_name(exit->signal) : last_line(hand.output);
    if (ends_.note(index, why))
      idle_ends_ = 0;
    else if (exit->signal == 0)
      throw Error(why);  // about the project or this machine, and so about all submissions
    else
      count_idle_end("a process that grades has ended: " + why);
    start(index);
  }

  void count_idle_end(const std::string& why) {
    if (++idle_ends_ >= most_idle_ends) throw Error(why);
  }

  static std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::string line = text.substr(text.rfind('\n') + 1);
    return shorten(printable(line.starts_with("error: ") ? line.substr(7) : line), 500);
  }

  const EngineSettings& settings_;
  const ClassPlan& plan_;
  WorkerEnds ends_;
  std::vector<Hand> hands_;
  int idle_ends_ = 0;
};

}  // namespace

void run_local_engine(const EngineSettings& settings, const ClassPlan& plan) {
  LocalEngine(settings, plan).run();
}

}  // namespace atelier
