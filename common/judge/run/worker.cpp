#include "judge/run/worker.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace atelier::judge {
namespace {

constexpr std::size_t max_line = 128;          ///< bytes; "begin " and a case's name have at most 70
constexpr std::size_t read_at_once = 1 << 16;  ///< bytes: the capacity of a Linux pipe

/// Appends what is in the pipe, at most read_at_once bytes; closes our end if the other side is closed.
void drain(Descriptor& pipe, std::string& text) {
  std::array<char, 4096> chunk;
  for (std::size_t all = 0; pipe && all < read_at_once;) {
    const ssize_t got = ::read(pipe.get(), chunk.data(), chunk.size());
    if (got > 0) {
      text.append(chunk.data(), static_cast<std::size_t>(got));
      all += static_cast<std::size_t>(got);
    } else if (got < 0 && errno == EINTR) {
      continue;
    } else {
      if (got == 0 || errno != EAGAIN) pipe.reset();
      break;
    }
  }
}

}  // namespace

Worker::Worker(Launch wanted, const sandbox::Sandbox* sandbox, const sandbox::Room& room) : sandbox_(sandbox) {
  Pipe progress = make_pipe(), output = make_pipe();
  const int printed = output.write.get();
  wanted.descriptors = {{printed, 1}, {printed, 2}, {progress.write.get(), progress_descriptor}};
  if (sandbox)
    confined_ = sandbox->confine(wanted, room);
  else
    confined_.launch = std::move(wanted);
  child_ = launch(confined_.launch);
  progress_ = std::move(progress.read), output_ = std::move(output.read);
  for (const Descriptor* pipe : {&progress_, &output_}) ::fcntl(pipe->get(), F_SETFL, O_NONBLOCK);
  if (!confined_.receive_answers(answers_)) kill();
}

Worker::~Worker() {
  kill();
}

std::vector<std::string> Worker::take_lines() {
  std::vector<std::string> lines;
  std::string text = std::exchange(line_, {});
  drain(progress_, text);
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    if (end - begin <= max_line) lines.push_back(text.substr(begin, end - begin));
  // Keep the beginning of a too long line, so that its end is not mistaken for a line.
  line_ = text.substr(begin, max_line + 1);
  return lines;
}

std::string Worker::take_output() {
  std::string text;
  drain(output_, text);
  return text;
}

std::optional<Exit> Worker::ended() {
  if (exit_) return exit_;
  // Do not reap the process yet, so that the system cannot reuse its process group's number.
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0)
    return {};
  kill();
  return exit_;
}

void Worker::kill() {
  if (exit_) return;
  const int status = kill_and_wait(child_);
  exit_ = Exit{.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
               .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  if (!sandbox_) return;
  sandbox_->program_ended();
  if (const int signal = sandbox::signal_of_status(exit_->status)) *exit_ = {.status = -1, .signal = signal};
}

}  // namespace atelier::judge
