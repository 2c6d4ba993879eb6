#include "judge/run/shard.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "case/exchange.hpp"

namespace atelier::judge {
namespace {

using std::chrono::milliseconds;
using Ended = Answer::Ended;

/// How long a program may take to exit after its last case. Its answers have been read by then.
constexpr milliseconds exit_limit{2'000};
constexpr std::size_t max_tail = 1024;  ///< bytes: an error message is one line

/// The last lines that a program printed: the last one that begins with "error: ", and the very last one.
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

/// Reads a program's answer to a case. Removes the picture afterwards, so that many large pictures do not fill the
/// disk.
Answer read_answer(const Case& c, const HeldFolder& folder, bool counted, const sandbox::Sandbox* sandbox) {
  Answer answer;
  const std::string pixels = c.name + ".pixels";
  try {
    if (!folder.in_place())
      throw Error("the program has moved, removed or replaced the folder for its answers: none of them is read");
    answer.error = read_case_error(folder, c.name + ".build_error");
    if (!answer.error.empty()) {
      answer.ended = Ended::build_failed;
      return answer;
    }
    answer.error = read_case_error(folder, c.name + ".exception");
    if (!answer.error.empty()) {
      answer.ended = Ended::crashed;
      if (sandbox && answer.error.find("std::bad_alloc") != std::string::npos)
        answer.error += fmt::format(" (a program gets {} of memory)", sandbox::in_words(sandbox->limits().memory));
      return answer;
    }
    answer.error = read_case_error(folder, c.name + ".error");
    if (!answer.error.empty()) return answer;
    if (c.probe.empty())
      answer.pixels = read_pixels(folder, pixels, c.size);
    else
      answer.values = read_values(folder, c.name + ".values");
    if (counted && c.probe.empty()) answer.counts = read_counts(folder, c.name + ".stats");
    answer.ended = Ended::normally;
  } catch (const Error& error) {
    answer.error = shorten(printable(error.what()), 500);
  }
  folder.remove_file(pixels);
  return answer;
}

}  // namespace

Shard::Shard(const RunSettings& settings, const std::vector<Case>& cases, std::deque<std::size_t> waiting,
             int& time_outs, Deliver deliver)
    : settings_(settings),
      cases_(cases),
      waiting_(std::move(waiting)),
      time_outs_(time_outs),
      deliver_(std::move(deliver)) {
  start();
}

/// What a confined program may use: its own file, the libraries beside it, its code, the cases.
sandbox::Room Shard::room(const std::filesystem::path& job, const std::filesystem::path& out) const {
  constexpr std::size_t bytes_per_pixel = 4 * sizeof(float), for_all_else = std::size_t(64) << 20;
  const std::filesystem::path program = std::filesystem::absolute(settings_.program);
  sandbox::Room room;
  room.readable = {program, program.parent_path().parent_path() / "lib", job};
  room.readable.insert(room.readable.end(), settings_.readable.begin(), settings_.readable.end());
  for (const Implementations::Root& root : settings_.implementations.roots())
    room.readable.push_back(root.only.empty() ? root.folder : root.folder / root.only);
  if (settings_.sandbox) room.limits.processes = settings_.sandbox->limits().processes;  // all have one account
  room.answers = out;
  room.answers_bytes = for_all_else;
  for (const std::size_t index : waiting_) {
    const glm::ivec2 size = cases_[index].size;
    const std::size_t picture = bytes_per_pixel * std::size_t(size.x) * std::size_t(size.y);
    room.answers_bytes = std::max(room.answers_bytes, for_all_else + 2 * picture);
  }
  return room;
}

/// Starts a process for the waiting cases, in a new folder, so that files of a crashed process are not read as answers.
void Shard::start() {
  out_.reset();
  folder_.emplace("atelier-run");
  HeldFolder out = folder_->held().create_folder("out");
  const std::filesystem::path job = folder_->path() / "job.json";
  nlohmann::json asks = nlohmann::json::array();
  for (const std::size_t index : waiting_) asks.push_back(to_json(cases_[index]));
  write_file(job, nlohmann::json{{"cases", asks}}.dump(1) + "\n");

  std::vector<std::string> arguments = {settings_.program.string(),
                                        "--cases",
                                        job.string(),
                                        "--out",
                                        out.path().string(),
                                        "--implementations",
                                        settings_.implementations.to_string(),
                                        "--progress",
                                        std::to_string(progress_descriptor)};
  if (settings_.count) arguments.push_back("--stats");
  if (settings_.truth) arguments.push_back("--truth");
  if (!settings_.context.empty() && !settings_.truth)
    arguments.insert(arguments.end(), {"--context", settings_.context});
  const Launch start{.arguments = std::move(arguments), .folder = {}, .environment = program_environment(settings_)};
  if (settings_.sandbox) {
    settings_.sandbox->give(out.path());
    alone_ = settings_.sandbox->is_idle();
    memory_kills_ = settings_.sandbox->memory_kills();
  }
  worker_ = std::make_unique<Worker>(start, settings_.sandbox, room(job, out.path()));
  if (Descriptor answers = worker_->take_answers())
    out_ = HeldFolder::received(out.path(), std::move(answers));
  else
    out_ = std::move(out);
  case_begun_ = false;
  output_.clear();
  tail_.clear();
  deadline_ = Clock::now() + settings_.start_limit;
}

void Shard::advance() {
  if (time_out_limit_reached() && !running_) return skip_waiting();
  // Check for the end before reading, so that everything written before the end is read.
  const std::optional<Exit> exit = worker_->ended();
  read_pipes();
  if (exit && !worker_->was_started()) {
    handle_not_started();
  } else if (exit) {
    const std::string words = in_words(*exit);
    if (exit->signal != 0) {
      // After an uncaught exception the last line says what it was. Use tail_, not output_, which lacks what was
      // printed before the last "end" line.
      const std::string last = last_words(tail_).line;
      const std::string why = last.starts_with("error: ") ? ": " + last.substr(7) : "";
      handle_end(Ended::crashed, words + " during this case" + why, words + " before its first case" + why);
    } else {
      const LastWords said = last_words(output_);
      const std::string refusal = exit->status == exit_ok ? "" : said.error.empty() ? said.line : said.error;
      handle_end(Ended::missing, words + " during this case",
                 refusal.empty() ? words + " before its first case" : refusal);
    }
  } else if (Clock::now() >= deadline_) {
    handle_end(
        Ended::timeout, fmt::format("this case took longer than {} s", settings_.case_limit.count() / 1000.0),
        fmt::format("the program did not begin its first case within {} s", settings_.start_limit.count() / 1000.0));
  }
}

void Shard::read_pipes() {
  const auto read_output = [this] {
    const std::string text = worker_->take_output();
    output_.append(text, 0, settings_.output_limit - std::min(settings_.output_limit, output_.size()));
    tail_ += text;
    tail_.erase(0, tail_.size() - std::min(tail_.size(), max_tail));
  };
  read_output();
  for (const std::string& line : worker_->take_lines()) {
    if (line.starts_with("begin ")) begin(line.substr(6));
    if (line.starts_with("end ")) {
      read_output();
      end(line.substr(4));
    }
  }
}

/// Ignores the message unless the case is waiting and no other case is running. So the time of a case starts only once.
void Shard::begin(const std::string& name) {
  const auto found =
      std::find_if(waiting_.begin(), waiting_.end(), [&](std::size_t index) { return cases_[index].name == name; });
  if (running_ || found == waiting_.end() || time_out_limit_reached()) return;
  running_ = *found;
  waiting_.erase(found);
  case_begun_ = true;
  since_ = Clock::now();
  deadline_ = since_ + settings_.case_limit;
}

void Shard::end(const std::string& name) {
  if (!running_ || cases_[*running_].name != name) return;
  Answer answer = read_answer(cases_[*running_], *out_, settings_.count, settings_.sandbox);
  answer.output = std::exchange(output_, {});
  answer.seconds = std::chrono::duration<double>(Clock::now() - since_).count();
  deliver_(*std::exchange(running_, {}), std::move(answer));
  deadline_ = Clock::now() + (waiting_.empty() ? exit_limit : settings_.case_limit);
}

/// Handles a process that has ended or must be killed. The running case gets the error. If the process had begun no
/// case, a new process would fail too, so all waiting cases get the error; otherwise a new process continues with them.
void Shard::handle_end(Ended how, const std::string& in_case, const std::string& before_any) {
  worker_.reset();
  if (how == Ended::timeout && (running_ || !waiting_.empty())) ++time_outs_;
  const auto give_up = [&](std::size_t index, const std::string& error) {
    Answer answer;
    answer.ended = how;
    answer.error = error;
    answer.output = output_;
    if (case_begun_) answer.seconds = std::chrono::duration<double>(Clock::now() - since_).count();
    deliver_(index, std::move(answer));
  };
  if (running_) give_up(*std::exchange(running_, {}), in_case);
  if (!case_begun_)
    for (; !waiting_.empty(); waiting_.pop_front()) give_up(waiting_.front(), before_any);
  if (waiting_.empty()) return;
  time_out_limit_reached() ? skip_waiting() : start();
}

/// Handles a sandbox that did not start the program. Where another one of the submission ran, that one may be why: it
/// has taken all processes, for example.
void Shard::handle_not_started() {
  const std::string why =
      "the sandbox did not start the program: " + sandbox::failure_of_sandbox(std::exchange(output_, {}));
  if (alone_ && settings_.sandbox->memory_kills() == memory_kills_) throw Error(why);
  handle_end(Ended::missing, why, why);
}

/// "the program was ended by a signal: segmentation fault (SIGSEGV)"
std::string Shard::in_words(const Exit& exit) const {
  if (exit.signal == SIGKILL && settings_.sandbox && settings_.sandbox->memory_kills() > memory_kills_)
    return fmt::format("the program was ended, since it needed more than {} of memory",
                       sandbox::in_words(settings_.sandbox->limits().memory));
  return exit.signal != 0 ? fmt::format("the program was ended by a signal: {}", signal_name(exit.signal))
                          : fmt::format("the program exited with status {}", exit.status);
}

/// Answers all waiting cases without asking the program.
void Shard::skip_waiting() {
  worker_.reset();
  for (; !waiting_.empty(); waiting_.pop_front()) {
    Answer answer;
    answer.ended = Ended::timeout;
    answer.error = fmt::format("this case was not run, because earlier cases timed out ({}): fix those first",
                               settings_.max_time_outs);
    deliver_(waiting_.front(), std::move(answer));
  }
}

}  // namespace atelier::judge
