#include "judge/run/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "case/exchange.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Ended = Answer::Ended;

/// How long a program may take to leave once its last case has ended. Its answers are safe by then.
constexpr milliseconds leave_limit{2'000};
constexpr std::size_t longest_tail = 1024;  ///< bytes: an error is one line

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

}  // namespace

Shard::Shard(const RunSettings& settings, const std::vector<Case>& cases, std::deque<std::size_t> waiting,
             fs::path folder, int& time_outs, Deliver deliver)
    : settings_(settings),
      cases_(cases),
      waiting_(std::move(waiting)),
      folder_(std::move(folder)),
      time_outs_(time_outs),
      deliver_(std::move(deliver)) {
  start();
}

/// Starts a process on what is waiting, in a folder of its own: what a crashed one left lying there is nobody's answer.
void Shard::start() {
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

void Shard::advance() {
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

void Shard::listen() {
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
void Shard::begin(const std::string& name) {
  const auto found =
      std::find_if(waiting_.begin(), waiting_.end(), [&](std::size_t index) { return cases_[index].name == name; });
  if (running_ || found == waiting_.end() || out_of_patience()) return;
  running_ = *found;
  waiting_.erase(found);
  begun_ = true;
  since_ = Clock::now();
  deadline_ = since_ + settings_.case_limit;
}

void Shard::end(const std::string& name) {
  if (!running_ || cases_[*running_].name != name) return;
  Answer answer = read_answer(cases_[*running_], folder_ / std::to_string(processes_) / "out", settings_.count);
  answer.output = std::exchange(output_, {});
  answer.seconds = std::chrono::duration<double>(Clock::now() - since_).count();
  deliver_(*std::exchange(running_, {}), std::move(answer));
  deadline_ = Clock::now() + (waiting_.empty() ? leave_limit : settings_.case_limit);
}

/// The process is over, or is to be. The case that ran is blamed; where none had begun, a new process would fare no
/// better, and every case that waits gets the same answer; otherwise what waits goes on in a new process.
void Shard::settle(Ended how, const std::string& in_case, const std::string& before_any) {
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
void Shard::leave_rest() {
  worker_.reset();
  for (; !waiting_.empty(); waiting_.pop_front()) {
    Answer answer;
    answer.ended = Ended::timeout;
    answer.error = fmt::format("this case was not drawn, because {} before it had not ended: mend those first",
                               settings_.most_time_outs);
    deliver_(waiting_.front(), std::move(answer));
  }
}

}  // namespace atelier::judge
