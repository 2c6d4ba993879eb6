#include "base/launch.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "base/error.hpp"

extern char** environ;

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr int free_from = 16;  // above all numbers that a child asks for

/// The same file under a number above the standard streams': a parent whose streams are closed is given such low
/// numbers, and what it prints would go there.
Descriptor above_standard_streams(Descriptor file) {
  return file.get() > 2 ? std::move(file) : Descriptor(::fcntl(file.get(), F_DUPFD_CLOEXEC, 3));
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
struct Ready {
  fs::path program;
  std::vector<std::string> argument_text, environment_text;
  std::vector<char*> arguments, environment;
  const char* folder = nullptr;
  std::vector<Passed> descriptors;
  Descriptor nothing;  ///< an empty standard input, where none is passed
  int report = -1;     ///< errno goes there where the start fails
  pid_t parent = 0;
};

Ready prepare(const Launch& wanted) {
  if (wanted.arguments.empty() || wanted.arguments.front().empty())
    throw Error("a command needs the name of a program");
  std::error_code ignored;
  if (!wanted.folder.empty() && !fs::is_directory(wanted.folder, ignored))
    throw Error(fmt::format("{}: cannot be started in the folder {}, which does not exist", wanted.arguments.front(),
                            wanted.folder.string()));
  Ready ready;
  ready.program = find_program(wanted.arguments.front());
  ready.argument_text = wanted.arguments;
  if (wanted.environment)
    for (const auto& [name, value] : *wanted.environment) ready.environment_text.push_back(name + "=" + value);
  else
    for (char** entry = environ; *entry; ++entry) ready.environment_text.emplace_back(*entry);
  ready.arguments = pointers(ready.argument_text);
  ready.environment = pointers(ready.environment_text);
  if (!wanted.folder.empty()) ready.folder = wanted.folder.c_str();
  ready.descriptors = wanted.descriptors;
  const auto is_input = [](const Passed& passed) { return passed.number == 0; };
  if (std::none_of(ready.descriptors.begin(), ready.descriptors.end(), is_input)) {
    ready.nothing = above_standard_streams(Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)));
    ready.descriptors.push_back({ready.nothing.get(), 0});
  }
  ready.parent = ::getpid();
  return ready;
}

// --- The child, between fork and exec: only calls that POSIX calls async-signal-safe ---

/// Marks every descriptor from 3 on to be closed by exec, whoever opened it.
void close_descriptors_at_exec() {
#if defined(CLOSE_RANGE_CLOEXEC)
  if (::close_range(3, ~0u, CLOSE_RANGE_CLOEXEC) == 0) return;
#endif
  const int last = int(std::min(::sysconf(_SC_OPEN_MAX), 65536L));
  for (int descriptor = 3; descriptor < last; ++descriptor) ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

/// Puts the descriptors where the program looks for them. First all are moved out of the way, since one may stand on
/// the number that another needs; what dup2 makes is not closed by exec.
bool arrange_descriptors(Ready& ready) {
  const auto move_away = [](int& descriptor) {
    const int moved = ::fcntl(descriptor, F_DUPFD_CLOEXEC, free_from);
    if (moved >= 0) descriptor = moved;
    return moved >= 0;
  };
  if (!move_away(ready.report)) return false;
  for (Passed& passed : ready.descriptors)
    if (!move_away(passed.ours)) return false;
  close_descriptors_at_exec();
  for (const Passed& passed : ready.descriptors)
    if (::dup2(passed.ours, passed.number) < 0) return false;
  return true;
}

/// Signals as a fresh program expects them: an ignored SIGPIPE, say, would be inherited.
void reset_signals() {
  for (int number = 1; number < NSIG; ++number)
    if (number != SIGKILL && number != SIGSTOP) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become(Ready& ready) {
  ::setpgid(0, 0);
#if defined(__linux__)
  // Ctrl-C reaches our group and not the child's: let the child die with us however we die.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != ready.parent) ::_exit(127);
#endif
  reset_signals();
  if (arrange_descriptors(ready) && (ready.folder == nullptr || ::chdir(ready.folder) == 0))
    ::execve(ready.program.c_str(), ready.arguments.data(), ready.environment.data());
  const int reason = errno;
  (void)!::write(ready.report, &reason, sizeof reason);
  ::_exit(127);
}

}  // namespace

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

pid_t launch(const Launch& wanted) {
  Ready ready = prepare(wanted);
  Pipe report = make_pipe();
  ready.report = report.write.get();

  // Whoever started us may have left SIGCHLD ignored; then the system forgets how a child ended.
  struct sigaction action {};
  if (::sigaction(SIGCHLD, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) ::signal(SIGCHLD, SIG_DFL);

  const pid_t child = ::fork();
  if (child == 0) become(ready);
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
  throw Error(fmt::format("program '{}' cannot be started: {}", wanted.arguments.front(),
                          std::generic_category().message(reason)));
}

int kill_and_wait(pid_t child) {
  ::kill(-child, SIGKILL);
  ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::map<std::string, std::string> own_environment() {
  std::map<std::string, std::string> environment;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    if (const std::size_t equals = text.find('='); equals != std::string::npos)
      environment[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return environment;
}

}  // namespace atelier
