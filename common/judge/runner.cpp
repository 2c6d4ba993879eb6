#include "judge/runner.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "case/exchange.hpp"
#include "case/printable.hpp"
#include "judge/worker.hpp"

extern char** environ;

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using Ended = Answer::Ended;

/// How long a program may take to leave once its last case has ended. Its answers are safe by then.
constexpr milliseconds leave_limit{2'000};
/// How often we look for the end of a program whose pipes do not tell of it: seldom where a child of its own holds them
/// open, often where they are closed, for then it is about to end.
constexpr milliseconds seldom{20}, often{1};
constexpr std::size_t longest_tail = 1024;  ///< bytes: an error is one line

void check(const RunSettings& settings, const std::vector<Case>& cases) {
  const auto in_range = [](const char* what, auto value, auto low, auto high) {
    if (value < low || value > high)
      throw Error(fmt::format("{}: {} is not allowed; it takes {}..{}", what, value, low, high));
  };
  in_range("workers", settings.workers, 1, 64);
  in_range("driver threads", settings.driver_threads, 0, 32);
  in_range("time limit of a case in milliseconds", settings.case_limit.count(), 1, 86'400'000);
  in_range("time limit of the start in milliseconds", settings.start_limit.count(), 1, 86'400'000);
  in_range("time-outs", settings.most_time_outs, 0, 1'000'000);
  constexpr const char* kinds[] = {"", "osmesa", "egl", "window"};
  if (std::find(std::begin(kinds), std::end(kinds), settings.context) == std::end(kinds))
    throw Error(
        fmt::format("context: '{}' is not allowed; it takes osmesa, egl, window, or nothing", settings.context));
  std::set<std::string> names;
  for (const Case& c : cases)
    if (!names.insert(c.name).second) throw Error(fmt::format("case '{}' is there twice", c.name));
}

/// "the program was ended: segmentation fault (SIGSEGV)"
std::string in_words(const Exit& exit) {
  return exit.signal != 0 ? fmt::format("the program was ended by a signal: {}", signal_name(exit.signal))
                          : fmt::format("the program ended itself with status {}", exit.status);
}

/// What a program says before it ends: its last line that begins with "error: ", and its last line of all.
struct LastWords {
  std::string error, line;
};

LastWords last_words(const std::string& output) {
  LastWords last;
  for (std::size_t begin = 0; begin < output.size();) {
    const std::size_t end = std::min(output.find('\n', begin), output.size());
    const std::string line = output.substr(begin, end - begin);
    if (line.starts_with("error: ")) last.error = shorten(printable(line.substr(7)), 500);
    if (!line.empty()) last.line = shorten(printable(line), 500);
    begin = end + 1;
  }
  return last;
}

/// Reads what a program left for a case that it has ended. Each file is read once and then removed, so that a long list
/// of large pictures does not fill the disk.
Answer read_answer(const Case& c, const fs::path& folder, bool counted) {
  Answer answer;
  const fs::path pixels = folder / (c.name + ".pixels"), values = folder / (c.name + ".values");
  try {
    answer.error = read_case_error(folder / (c.name + ".build_error"));
    if (!answer.error.empty()) {
      answer.ended = Ended::build_failed;
      return answer;
    }
    answer.error = read_case_error(folder / (c.name + ".exception"));
    if (!answer.error.empty()) {
      answer.ended = Ended::crashed;
      return answer;
    }
    answer.error = read_case_error(folder / (c.name + ".error"));
    if (!answer.error.empty()) return answer;
    if (c.probe.empty())
      answer.pixels = read_pixels(pixels, c.size);
    else
      answer.values = read_values(values);
    if (counted && c.probe.empty()) answer.counts = read_counts(folder / (c.name + ".stats"));
    answer.ended = Ended::normally;
  } catch (const Error& error) {
    answer.error = shorten(printable(error.what()), 500);
  }
  std::error_code ignored;
  fs::remove(pixels, ignored);
  return answer;
}

/// The cases that one process at a time works through.
class Share {
 public:
  using Deliver = std::function<void(std::size_t index, Answer)>;

  /// `time_outs` is counted by all shares of a run together.
  Share(const RunSettings& settings, const std::vector<Case>& cases, std::deque<std::size_t> waiting, fs::path folder,
        int& time_outs, Deliver deliver)
      : settings_(settings),
        cases_(cases),
        waiting_(std::move(waiting)),
        folder_(std::move(folder)),
        time_outs_(time_outs),
        deliver_(std::move(deliver)) {
    start();
  }

  bool done() const { return worker_ == nullptr; }
  const Worker& worker() const { return *worker_; }
  Clock::time_point deadline() const { return deadline_; }

  /// Takes in what has happened since the last call; never waits.
  void advance();

 private:
  void start();
  void listen();
  void begin(const std::string& name);
  void end(const std::string& name);
  void settle(Ended how, const std::string& in_case, const std::string& before_any);
  bool out_of_patience() const { return settings_.most_time_outs > 0 && time_outs_ >= settings_.most_time_outs; }
  void leave_rest();

  const RunSettings& settings_;
  const std::vector<Case>& cases_;
  std::deque<std::size_t> waiting_;     ///< not begun yet, in order
  std::optional<std::size_t> running_;  ///< begun and not ended
  fs::path folder_;                     ///< of the process: its job file and its answers
  int& time_outs_;
  Deliver deliver_;
  std::unique_ptr<Worker> worker_;
  int processes_ = 0;
  bool begun_ = false;  ///< this process has begun a case
  std::string output_;  ///< printed since the last end
  std::string tail_;    ///< the last that this process has printed, in whatever case
  Clock::time_point since_, deadline_;
};

/// Starts a process on what is waiting, in a folder of its own: what a crashed one left lying there is nobody's answer.
void Share::start() {
  const fs::path folder = folder_ / std::to_string(++processes_), out = folder / "out", job = folder / "job.json";
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw Error(fmt::format("{}: cannot be made: {}", out.string(), error.message()));
  nlohmann::json asks = nlohmann::json::array();
  for (const std::size_t index : waiting_) asks.push_back(to_json(cases_[index]));
  write_file(job, nlohmann::json{{"cases", asks}}.dump(1) + "\n");

  std::vector<std::string> arguments = {settings_.program.string(),
                                        "--cases",
                                        job.string(),
                                        "--out",
                                        out.string(),
                                        "--implementations",
                                        settings_.implementations.to_string(),
                                        "--progress",
                                        std::to_string(progress_descriptor)};
  if (settings_.count) arguments.push_back("--stats");
  if (settings_.truth) arguments.push_back("--truth");
  if (!settings_.context.empty() && !settings_.truth)
    arguments.insert(arguments.end(), {"--context", settings_.context});
  worker_ = std::make_unique<Worker>(arguments, program_environment(settings_));
  begun_ = false;
  output_.clear();
  tail_.clear();
  deadline_ = Clock::now() + settings_.start_limit;
}

void Share::advance() {
  if (out_of_patience() && !running_) return leave_rest();
  // Asked before listening: what was written before the end is then in the pipes and is heard.
  const std::optional<Exit> exit = worker_->ended();
  listen();
  if (exit) {
    const std::string words = in_words(*exit);
    if (exit->signal != 0) {
      // The very last line says what was thrown, where that is what ended it. Not output_: what is printed close to a
      // case's end may be counted to its neighbour.
      const std::string last = last_words(tail_).line;
      const std::string why = last.starts_with("error: ") ? ": " + last.substr(7) : "";
      settle(Ended::crashed, words + " during this case" + why, words + " before its first case" + why);
    } else {
      const LastWords said = last_words(output_);
      const std::string refusal = exit->status == exit_ok ? "" : said.error.empty() ? said.line : said.error;
      settle(Ended::missing, words + " during this case", refusal.empty() ? words + " before its first case" : refusal);
    }
  } else if (Clock::now() >= deadline_) {
    settle(Ended::timeout, fmt::format("this case lasted longer than {} s", settings_.case_limit.count() / 1000.0),
           fmt::format("the program did not begin its first case within {} s", settings_.start_limit.count() / 1000.0));
  }
}

void Share::listen() {
  const auto hear = [this] {
    const std::string text = worker_->take_output();
    output_.append(text, 0, settings_.output_limit - std::min(settings_.output_limit, output_.size()));
    tail_ += text;
    tail_.erase(0, tail_.size() - std::min(tail_.size(), longest_tail));
  };
  hear();
  for (const std::string& line : worker_->take_lines()) {
    if (line.starts_with("begin ")) begin(line.substr(6));
    if (line.starts_with("end ")) {
      hear();
      end(line.substr(4));
    }
  }
}

/// Believed only of a case that is asked for and waits, and while no other runs: every case starts its clock once.
void Share::begin(const std::string& name) {
  const auto found =
      std::find_if(waiting_.begin(), waiting_.end(), [&](std::size_t index) { return cases_[index].name == name; });
  if (running_ || found == waiting_.end() || out_of_patience()) return;
  running_ = *found;
  waiting_.erase(found);
  begun_ = true;
  since_ = Clock::now();
  deadline_ = since_ + settings_.case_limit;
}

void Share::end(const std::string& name) {
  if (!running_ || cases_[*running_].name != name) return;
  Answer answer = read_answer(cases_[*running_], folder_ / std::to_string(processes_) / "out", settings_.count);
  answer.output = std::exchange(output_, {});
  answer.seconds = std::chrono::duration<double>(Clock::now() - since_).count();
  deliver_(*std::exchange(running_, {}), std::move(answer));
  deadline_ = Clock::now() + (waiting_.empty() ? leave_limit : settings_.case_limit);
}

/// The process is over, or is to be. The case that ran is blamed; where none had begun, a new process would fare no
/// better, and every case that waits gets the same answer; otherwise what waits goes on in a new process.
void Share::settle(Ended how, const std::string& in_case, const std::string& before_any) {
  worker_.reset();
  if (how == Ended::timeout && (running_ || !waiting_.empty())) ++time_outs_;
  const auto give_up = [&](std::size_t index, const std::string& error) {
    Answer answer;
    answer.ended = how;
    answer.error = error;
    answer.output = output_;
    if (begun_) answer.seconds = std::chrono::duration<double>(Clock::now() - since_).count();
    deliver_(index, std::move(answer));
  };
  if (running_) give_up(*std::exchange(running_, {}), in_case);
  if (!begun_)
    for (; !waiting_.empty(); waiting_.pop_front()) give_up(waiting_.front(), before_any);
  if (waiting_.empty()) return;
  out_of_patience() ? leave_rest() : start();
}

/// What waits is not asked any more.
void Share::leave_rest() {
  worker_.reset();
  for (; !waiting_.empty(); waiting_.pop_front()) {
    Answer answer;
    answer.ended = Ended::timeout;
    answer.error = fmt::format("this case was not drawn, because {} before it had not ended: mend those first",
                               settings_.most_time_outs);
    deliver_(waiting_.front(), std::move(answer));
  }
}

/// Sleeps until a program has something to tell, a limit is reached, or it is time for a look.
void wait_for_any(const std::vector<std::unique_ptr<Share>>& shares) {
  std::vector<pollfd> pipes;
  const auto now = Clock::now();
  auto until = now + seldom;
  for (const auto& share : shares) {
    if (share->done()) continue;
    for (const int pipe : {share->worker().progress(), share->worker().output()}) {
      pipes.push_back({pipe, POLLIN, 0});  // poll passes over -1
      if (pipe < 0) until = std::min(until, now + often);
    }
    until = std::min(until, share->deadline());
  }
  const auto left = std::chrono::ceil<milliseconds>(until - Clock::now());
  ::poll(pipes.data(), pipes.size(), static_cast<int>(std::max(left, milliseconds(0)).count()));
}

/// Shares for at most `workers` processes, none of them empty. Neighbours with the same scene stay together: the first
/// makes the scene and compiles its shaders, which takes about three times as long as to draw it once more. But only
/// so far, for the processes are to end together.
std::vector<std::deque<std::size_t>> deal(const std::vector<Case>& cases, const std::vector<std::size_t>& order,
                                          std::size_t workers) {
  constexpr int first_of_scene = 3, one_more = 1, most_ahead = 6;  // of the share that has least to do
  struct Load {
    std::deque<std::size_t> cases;
    int work = 0;
  };
  std::vector<Load> loads(std::min(workers, cases.size()));
  const auto ends_with_scene_of = [&](const Load& load, std::size_t index) {
    return !load.cases.empty() && cases[load.cases.back()].scene == cases[index].scene;
  };
  Load* last = nullptr;
  for (const std::size_t index : order) {
    const auto least =
        std::min_element(loads.begin(), loads.end(), [](const Load& a, const Load& b) { return a.work < b.work; });
    const bool stays = last && ends_with_scene_of(*last, index) && last->work < least->work + most_ahead &&
                       last->cases.size() * loads.size() < cases.size();
    if (!stays) last = &*least;
    last->work += ends_with_scene_of(*last, index) ? one_more : first_of_scene;
    last->cases.push_back(index);
  }
  std::vector<std::deque<std::size_t>> shares;
  for (Load& load : loads) shares.push_back(std::move(load.cases));
  return shares;
}

bool bends_the_driver(const std::string& variable) {
  constexpr const char* prefixes[] = {"LP_", "GALLIUM_", "GALLIVM_", "MESA_", "LIBGL_", "LD_", "LC_"};
  return std::any_of(std::begin(prefixes), std::end(prefixes),
                     [&](const char* prefix) { return variable.starts_with(prefix); });
}

}  // namespace

std::map<std::string, std::string> program_environment(const RunSettings& settings) {
  std::map<std::string, std::string> environment;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos && !bends_the_driver(text))
      environment[text.substr(0, equals)] = text.substr(equals + 1);
  }
  environment["LANG"] = "C";
  environment["LP_NUM_THREADS"] = std::to_string(settings.driver_threads);
  // Without LLVM's optimisation passes llvmpipe compiles shaders in half the time, and draws the same bits.
  environment["GALLIVM_PERF"] = "nopt";
  if (settings.shader_cache.empty())
    environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  else
    environment["MESA_SHADER_CACHE_DIR"] = fs::absolute(settings.shader_cache).string();
  // A program built with sanitizers would exit by itself: what they find is to count as the crash that it is.
  for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS"}) environment.try_emplace(name, "abort_on_error=1");
  for (const auto& [name, value] : settings.environment) environment[name] = value;
  return environment;
}

std::vector<std::size_t> asking_order(std::size_t count, std::optional<std::uint64_t> seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (!seed) return order;
  // Fisher and Yates' shuffle by hand: std::shuffle draws differently in every standard library.
  std::mt19937_64 random(*seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

std::vector<Answer> run_cases(const RunSettings& settings, const std::vector<Case>& cases, const OnAnswer& on_answer) {
  check(settings, cases);
  if (!settings.shader_cache.empty()) {
    std::error_code error;
    fs::create_directories(settings.shader_cache, error);
    if (error) throw Error(fmt::format("{}: cannot be made: {}", settings.shader_cache.string(), error.message()));
  }
  std::vector<Answer> answers(cases.size());
  const auto deliver = [&](std::size_t index, Answer answer) {
    answers[index] = std::move(answer);
    if (on_answer) on_answer(index, answers[index]);
  };

  const auto indices =
      deal(cases, asking_order(cases.size(), settings.shuffle), static_cast<std::size_t>(settings.workers));
  const TemporaryFolder folder("atelier-run");
  int time_outs = 0;
  std::vector<std::unique_ptr<Share>> shares;
  for (std::size_t i = 0; i < indices.size(); ++i)
    shares.push_back(
        std::make_unique<Share>(settings, cases, indices[i], folder.path() / std::to_string(i), time_outs, deliver));
  const auto done = [](const auto& share) { return share->done(); };
  while (!std::all_of(shares.begin(), shares.end(), done)) {
    wait_for_any(shares);
    if (settings.interrupted && settings.interrupted()) throw Interrupted();
    for (const auto& share : shares)
      if (!share->done()) share->advance();
  }
  return answers;
}

}  // namespace atelier::judge
