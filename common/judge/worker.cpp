#include "judge/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "base/error.hpp"

namespace atelier::judge {
namespace {

constexpr std::size_t longest_line = 128;      ///< bytes; "begin " and a case's name are at most 70
constexpr std::size_t read_at_once = 1 << 16;  ///< bytes: what a Linux pipe holds

struct Pipe {
  Descriptor read, write;
};

/// Both ends close-on-exec: no other child is to hold a worker's pipe open.
Pipe make_pipe() {
  int ends[2];
  if (::pipe(ends) != 0) throw Error("no pipe can be made: " + std::generic_category().message(errno));
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

/// What the child needs, made before the fork: afterwards, a child of a threaded program may not allocate.
struct Launch {
  std::vector<char*> arguments, environment;
  int input, output, progress, report;  ///< descriptors; `report` gets errno where the start fails
  pid_t parent;
};

/// Puts the program's descriptors where it looks for them, and marks all others to be closed by exec. First each is
/// moved out of the way: the progress pipe may stand on the number that another one needs.
bool arrange_descriptors(Launch& launch) {
  constexpr int free_from = 16;
  for (int* moved : {&launch.input, &launch.output, &launch.progress, &launch.report}) {
    *moved = ::fcntl(*moved, F_DUPFD_CLOEXEC, free_from);
    if (*moved < 0) return false;
  }
  if (::dup2(launch.input, 0) < 0 || ::dup2(launch.output, 1) < 0 || ::dup2(launch.output, 2) < 0 ||
      ::dup2(launch.progress, progress_descriptor) < 0)
    return false;
  constexpr int first_other = progress_descriptor + 1;
#if defined(CLOSE_RANGE_CLOEXEC)
  if (::close_range(first_other, ~0u, CLOSE_RANGE_CLOEXEC) == 0) return true;
#endif
  const int end = static_cast<int>(std::min(::sysconf(_SC_OPEN_MAX), 65536L));
  for (int number = first_other; number < end; ++number) ::fcntl(number, F_SETFD, FD_CLOEXEC);
  return true;
}

/// The child, between fork and exec: only what POSIX calls async-signal-safe.
[[noreturn]] void become(Launch& launch) {
  ::setpgid(0, 0);
#if defined(__linux__)
  // A student's endless loop must not outlive a judge that was interrupted or killed.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != launch.parent) ::_exit(127);
#endif
  for (int number = 1; number < NSIG; ++number)
    if (number != SIGKILL && number != SIGSTOP) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);

  if (arrange_descriptors(launch)) ::execve(launch.arguments[0], launch.arguments.data(), launch.environment.data());
  const int reason = errno;
  (void)!::write(launch.report, &reason, sizeof reason);
  ::_exit(127);
}

/// The errno that a child reports in place of running the program; 0 once exec has closed the pipe.
int start_error(const Descriptor& report) {
  int reason = 0;
  ssize_t got;
  do got = ::read(report.get(), &reason, sizeof reason);
  while (got < 0 && errno == EINTR);
  return reason;
}

/// Appends what is in the pipe, at most read_at_once bytes; closes our end once the other side is closed.
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

Worker::Worker(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment) {
  if (arguments.empty()) throw Error("a worker needs the path of a program");
  std::vector<std::string> variables;
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);

  Pipe progress = make_pipe(), output = make_pipe(), report = make_pipe();
  const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  Launch launch{pointers(arguments),  pointers(variables), nothing.get(), output.write.get(),
                progress.write.get(), report.write.get(),  ::getpid()};
  child_ = ::fork();
  if (child_ == 0) become(launch);
  int reason = errno;
  report.write.reset();
  if (child_ > 0) {
    ::setpgid(child_, child_);  // by both sides: whichever comes first, the group is there from here on
    reason = start_error(report.read);
    if (reason != 0) ::waitpid(child_, nullptr, 0);
  }
  if (reason != 0 || child_ < 0)
    throw Error(fmt::format("{}: cannot be started: {}", arguments[0], std::generic_category().message(reason)));

  progress_ = std::move(progress.read), output_ = std::move(output.read);
  for (const Descriptor* pipe : {&progress_, &output_}) ::fcntl(pipe->get(), F_SETFL, O_NONBLOCK);
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
    if (end - begin <= longest_line) lines.push_back(text.substr(begin, end - begin));
  // Of an endless line its begin is kept, so that its end is not taken for a line of its own.
  line_ = text.substr(begin, longest_line + 1);
  return lines;
}

std::string Worker::take_output() {
  std::string text;
  drain(output_, text);
  return text;
}

std::optional<Exit> Worker::ended() {
  if (exit_) return exit_;
  // Looked at without reaping: as long as the program's number is not given up, its group's number is not either.
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0)
    return {};
  kill();
  return exit_;
}

void Worker::kill() {
  if (exit_) return;
  ::kill(-child_, SIGKILL);
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  exit_ = Exit{.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
               .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

}  // namespace atelier::judge
