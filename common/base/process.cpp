#include "base/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "base/launch.hpp"

namespace atelier {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Whether the child has ended. Does not reap it, so that the system cannot reuse its process group's number.
bool has_ended(pid_t child) {
  siginfo_t info{};
  return ::waitid(P_PID, id_t(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == child;
}

enum class PipeState { open, closed };

/// Reads what is in the pipe now; `output` gets at most `limit` bytes in all.
PipeState drain(int pipe, std::string& output, std::size_t limit) {
  std::array<char, 16384> chunk;
  // Bounded, so that a child that floods the pipe cannot outrun the time limit.
  for (int round = 0; round < 64; ++round) {
    const ssize_t got = ::read(pipe, chunk.data(), chunk.size());
    if (got == 0) return PipeState::closed;
    if (got < 0) return errno == EAGAIN || errno == EINTR ? PipeState::open : PipeState::closed;
    output.append(chunk.data(), std::min(std::size_t(got), limit - output.size()));
  }
  return PipeState::open;
}

/// Waits until the child ends or the deadline passes, and collects output. Returns true if the deadline came first.
bool wait_until(pid_t child, int pipe, Clock::time_point deadline, const Command& command, std::string& output) {
  // The pipe normally closes when the child ends. It does not if a grandchild holds it, and it closes too early if the
  // child closes its side, so the loop also polls for the child's end.
  PipeState state = PipeState::open;
  while (!has_ended(child)) {
    const auto now = Clock::now();
    if (now >= deadline) return true;
    const auto left = std::chrono::ceil<milliseconds>(deadline - now);
    const milliseconds interval{state == PipeState::open ? 10 : 1};
    pollfd wait{state == PipeState::open ? pipe : -1, POLLIN, 0};  // poll ignores -1
    ::poll(&wait, 1, int(std::min(left, interval).count()));
    if (state == PipeState::open) state = drain(pipe, output, command.output_limit);
  }
  return false;
}

}  // namespace

Finished run_process(const Command& command) {
  Pipe pipe = make_pipe();
  ::fcntl(pipe.read.get(), F_SETFL, O_NONBLOCK);
  const auto begin = Clock::now();
  const int output = pipe.write.get();
  Launch wanted{.arguments = command.arguments,
                .folder = command.folder,
                .environment = command.environment,
                .descriptors = command.descriptors};
  wanted.descriptors.insert(wanted.descriptors.end(), {{output, 1}, {output, 2}});
  const pid_t child = launch(wanted);
  pipe.write.reset();

  Finished result;
  result.timed_out = wait_until(child, pipe.read.get(), begin + command.time_limit, command, result.output);
  const int status = kill_and_wait(child);
  drain(pipe.read.get(), result.output, command.output_limit);

  result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.exit_status = WIFEXITED(status) && !result.timed_out ? WEXITSTATUS(status) : -1;
  return result;
}

std::string signal_name(int signal) {
  switch (signal) {
    case SIGABRT:
      return "aborted (SIGABRT)";
    case SIGBUS:
      return "bus error (SIGBUS)";
    case SIGFPE:
      return "arithmetic fault, such as an integer division by zero (SIGFPE)";
    case SIGHUP:
      return "hang-up (SIGHUP)";
    case SIGILL:
      return "illegal instruction (SIGILL)";
    case SIGINT:
      return "interrupted (SIGINT)";
    case SIGKILL:
      return "killed (SIGKILL)";
    case SIGPIPE:
      return "wrote to a closed pipe (SIGPIPE)";
    case SIGSEGV:
      return "segmentation fault (SIGSEGV)";
    case SIGSYS:
      return "forbidden system call (SIGSYS)";
    case SIGTERM:
      return "terminated (SIGTERM)";
    case SIGTRAP:
      return "trap (SIGTRAP)";
    case SIGXCPU:
      return "processor time used up (SIGXCPU)";
    case SIGXFSZ:
      return "file grew too large (SIGXFSZ)";
    default:
      return fmt::format("signal {}", signal);
  }
}

}  // namespace atelier
