#include "base/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "base/descriptor.hpp"
#include "base/error.hpp"

extern char** environ;

namespace atelier {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

struct Pipe {
  Descriptor read, write;
};

/// The same file under a number above the standard streams', which a child's own take the place of: a parent whose
/// streams are closed is given such low numbers.
Descriptor above_standard_streams(Descriptor file) {
  return file.get() > 2 ? std::move(file) : Descriptor(::fcntl(file.get(), F_DUPFD_CLOEXEC, 3));
}

/// Both ends close-on-exec from the start, so that a child started meanwhile by another thread inherits neither.
Pipe make_pipe() {
  int ends[2];
#if defined(__linux__)
  const int failed = ::pipe2(ends, O_CLOEXEC);
#else
  const int failed = ::pipe(ends);
  if (!failed)
    for (int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
#endif
  if (failed) throw Error("no pipe can be made: " + std::generic_category().message(errno));
  return {above_standard_streams(Descriptor(ends[0])), above_standard_streams(Descriptor(ends[1]))};
}

bool is_program(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

/// The absolute path behind a program's name: itself where it has a slash, otherwise the first match along PATH. Done
/// here and not by exec, because the child's folder and environment may be others than ours.
fs::path find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return fs::absolute(name);
  const char* variable = std::getenv("PATH");
  const std::string path = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    const fs::path folder = end == begin ? fs::path(".") : fs::path(path.substr(begin, end - begin));
    if (is_program(folder / name)) return fs::absolute(folder / name);
    begin = end + 1;
  }
  throw Error(fmt::format("program '{}' is not found along PATH ({})", name, path));
}

/// What execve wants: pointers, ended by a null, into strings that live on.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& text : strings) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Everything that the child needs, made ready before the fork: after it, a child of a threaded program may neither
/// allocate nor lock.
struct Launch {
  fs::path program;
  std::vector<std::string> argument_text, environment_text;
  std::vector<char*> arguments, environment;
  const char* folder = nullptr;
  int input = -1, output = -1, report = -1;  ///< descriptors; errno goes to `report` where the start fails
  pid_t parent = 0;
};

Launch prepare(const Command& command) {
  if (command.arguments.empty() || command.arguments.front().empty())
    throw Error("a command needs the name of a program");
  std::error_code ignored;
  if (!command.folder.empty() && !fs::is_directory(command.folder, ignored))
    throw Error(fmt::format("{}: cannot be started in the folder {}, which does not exist", command.arguments.front(),
                            command.folder.string()));
  Launch launch;
  launch.program = find_program(command.arguments.front());
  launch.argument_text = command.arguments;
  if (command.environment)
    for (const auto& [name, value] : *command.environment) launch.environment_text.push_back(name + "=" + value);
  else
    for (char** entry = environ; *entry; ++entry) launch.environment_text.emplace_back(*entry);
  launch.arguments = pointers(launch.argument_text);
  launch.environment = pointers(launch.environment_text);
  if (!command.folder.empty()) launch.folder = command.folder.c_str();
  launch.parent = ::getpid();
  return launch;
}

/// Marks every descriptor from 3 on to be closed by exec, whoever opened it.
void close_descriptors_at_exec() {
#if defined(CLOSE_RANGE_CLOEXEC)
  if (::close_range(3, ~0u, CLOSE_RANGE_CLOEXEC) == 0) return;
#endif
  const int last = int(std::min(::sysconf(_SC_OPEN_MAX), 65536L));
  for (int descriptor = 3; descriptor < last; ++descriptor) ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

/// The child, between fork and exec: only calls that POSIX calls async-signal-safe.
[[noreturn]] void become(const Launch& launch) {
  ::setpgid(0, 0);
#if defined(__linux__)
  // Ctrl-C reaches our group and not the child's: let the child die with us however we die.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != launch.parent) ::_exit(127);
#endif
  // Signals as a fresh program expects them: an ignored SIGPIPE, say, would be inherited.
  for (int number = 1; number < NSIG; ++number)
    if (number != SIGKILL && number != SIGSTOP) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);

  const bool ready = ::dup2(launch.input, 0) >= 0 && ::dup2(launch.output, 1) >= 0 && ::dup2(launch.output, 2) >= 0 &&
                     (launch.folder == nullptr || ::chdir(launch.folder) == 0);
  if (ready) {
    close_descriptors_at_exec();
    ::execve(launch.program.c_str(), launch.arguments.data(), launch.environment.data());
  }
  const int reason = errno;
  (void)!::write(launch.report, &reason, sizeof reason);
  ::_exit(127);
}

/// Forks and waits until the program itself runs. `output` is the end of a pipe that it writes to.
pid_t start(const Command& command, const Descriptor& output) {
  Launch launch = prepare(command);
  const Descriptor nothing = above_standard_streams(Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)));
  Pipe report = make_pipe();
  launch.input = nothing.get(), launch.output = output.get(), launch.report = report.write.get();

  // Whoever started us may have left SIGCHLD ignored; then the system forgets how a child ended.
  struct sigaction action {};
  if (::sigaction(SIGCHLD, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) ::signal(SIGCHLD, SIG_DFL);

  const pid_t child = ::fork();
  if (child == 0) become(launch);
  int reason = errno;
  report.write.reset();
  if (child > 0) {
    ::setpgid(child, child);  // by both sides: whichever comes first, the group is there from here on
    ssize_t got;
    do got = ::read(report.read.get(), &reason, sizeof reason);
    while (got < 0 && errno == EINTR);
    if (got == 0) return child;  // exec closed the pipe
    ::waitpid(child, nullptr, 0);
  }
  throw Error(fmt::format("program '{}' cannot be started: {}", command.arguments.front(),
                          std::generic_category().message(reason)));
}

/// Whether the child has ended. It is left unreaped: until then nobody else can be given its process group's number.
bool has_ended(pid_t child) {
  siginfo_t info{};
  return ::waitid(P_PID, id_t(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == child;
}

enum class Drained { open, closed };

/// Takes what is in the pipe by now; keeps at most `limit` bytes in all.
Drained drain(int pipe, std::string& kept, std::size_t limit) {
  std::array<char, 16384> chunk;
  // Bounded, so that a child that floods the pipe does not keep us from looking at the clock.
  for (int round = 0; round < 64; ++round) {
    const ssize_t got = ::read(pipe, chunk.data(), chunk.size());
    if (got == 0) return Drained::closed;
    if (got < 0) return errno == EAGAIN || errno == EINTR ? Drained::open : Drained::closed;
    kept.append(chunk.data(), std::min(std::size_t(got), limit - kept.size()));
  }
  return Drained::open;
}

/// Waits for the child's end or the limit, collecting output. Returns true where the limit came first.
bool watch(pid_t child, int pipe, Clock::time_point deadline, const Command& command, std::string& output) {
  // The pipe's end normally tells of the child's. It does not where a grandchild holds the pipe or the child has closed
  // its own side: then we look for the end ourselves.
  Drained state = Drained::open;
  while (!has_ended(child)) {
    const auto now = Clock::now();
    if (now >= deadline) return true;
    const auto left = std::chrono::ceil<milliseconds>(deadline - now);
    const milliseconds glance{state == Drained::open ? 10 : 1};
    pollfd wait{state == Drained::open ? pipe : -1, POLLIN, 0};  // poll passes over -1
    ::poll(&wait, 1, int(std::min(left, glance).count()));
    if (state == Drained::open) state = drain(pipe, output, command.output_limit);
  }
  return false;
}

}  // namespace

Finished run_process(const Command& command) {
  Pipe pipe = make_pipe();
  ::fcntl(pipe.read.get(), F_SETFL, O_NONBLOCK);
  const auto begin = Clock::now();
  const pid_t child = start(command, pipe.write);
  pipe.write.reset();

  Finished result;
  result.timed_out = watch(child, pipe.read.get(), begin + command.time_limit, command, result.output);
  ::kill(-child, SIGKILL);  // with all that it has started
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
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
