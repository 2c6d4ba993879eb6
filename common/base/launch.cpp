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
#include "base/system_reason.hpp"

extern char** environ;

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr int first_free_number = 16;  // above every number in Launch::descriptors

/// The same file with a number above those of the standard streams. If the parent's standard streams are closed, new
/// files get their numbers, and printed text would go there.
Descriptor above_standard_streams(Descriptor file) {
  return file.get() > 2 ? std::move(file) : Descriptor(::fcntl(file.get(), F_DUPFD_CLOEXEC, 3));
}

bool is_program(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

/// A null-terminated array of pointers, as execve takes it. `strings` must outlive it.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& text : strings) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Everything that the child needs, prepared before the fork: after it, the child of a threaded program must not
/// allocate or lock.
struct PreparedLaunch {
  fs::path program;
  std::vector<std::string> argument_text, environment_text;
  std::vector<char*> arguments, environment;
  const char* folder = nullptr;
  std::vector<PassedDescriptor> descriptors;
  Descriptor empty_input;  ///< the standard input if the caller passes none
  int error_pipe = -1;     ///< receives errno if the start fails
  pid_t parent = 0;
};

PreparedLaunch prepare(const Launch& wanted) {
  if (wanted.arguments.empty() || wanted.arguments.front().empty())
    throw Error("the name of the program to start is missing");
  std::error_code ignored;
  if (!wanted.folder.empty() && !fs::is_directory(wanted.folder, ignored))
    throw Error(fmt::format("{}: cannot be started in the folder {}: it does not exist", wanted.arguments.front(),
                            wanted.folder.string()));
  PreparedLaunch ready;
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
  const auto is_input = [](const PassedDescriptor& passed) { return passed.child_number == 0; };
  if (std::none_of(ready.descriptors.begin(), ready.descriptors.end(), is_input)) {
    ready.empty_input = above_standard_streams(Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)));
    ready.descriptors.push_back({ready.empty_input.get(), 0});
  }
  ready.parent = ::getpid();
  return ready;
}

// --- The child, between fork and exec: only async-signal-safe calls (POSIX) ---

/// Marks every descriptor from 3 on as close-on-exec.
void close_descriptors_at_exec() {
#if defined(CLOSE_RANGE_CLOEXEC)
  if (::close_range(3, ~0u, CLOSE_RANGE_CLOEXEC) == 0) return;
#endif
  const int last = int(std::min(::sysconf(_SC_OPEN_MAX), 65536L));
  for (int descriptor = 3; descriptor < last; ++descriptor) ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

/// Gives the descriptors the numbers that the program expects. First it moves all of them to high numbers, since one
/// may have the number that another needs. dup2 clears close-on-exec.
bool arrange_descriptors(PreparedLaunch& ready) {
  const auto move_away = [](int& descriptor) {
    const int moved = ::fcntl(descriptor, F_DUPFD_CLOEXEC, first_free_number);
    if (moved >= 0) descriptor = moved;
    return moved >= 0;
  };
  if (!move_away(ready.error_pipe)) return false;
  for (PassedDescriptor& passed : ready.descriptors)
    if (!move_away(passed.parent_number)) return false;
  close_descriptors_at_exec();
  for (const PassedDescriptor& passed : ready.descriptors)
    if (::dup2(passed.parent_number, passed.child_number) < 0) return false;
  return true;
}

/// Restores the default signal handling; the child would inherit an ignored SIGPIPE, for example.
void reset_signals() {
  for (int number = 1; number < NSIG; ++number)
    if (number != SIGKILL && number != SIGSTOP) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void exec_child(PreparedLaunch& ready) {
  ::setpgid(0, 0);
#if defined(__linux__)
  // Ctrl-C reaches only our process group, so the kernel must kill the child when we end.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != ready.parent) ::_exit(127);
#endif
  reset_signals();
  if (arrange_descriptors(ready) && (ready.folder == nullptr || ::chdir(ready.folder) == 0))
    ::execve(ready.program.c_str(), ready.arguments.data(), ready.environment.data());
  const int reason = errno;
  (void)!::write(ready.error_pipe, &reason, sizeof reason);
  ::_exit(127);
}

}  // namespace

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
  throw Error(fmt::format("program '{}' is not found in PATH ({})", name, path));
}

Pipe make_pipe() {
  int ends[2];
#if defined(__linux__)
  const int failed = ::pipe2(ends, O_CLOEXEC);
#else
  const int failed = ::pipe(ends);
  if (!failed)
    for (int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
#endif
  if (failed) throw Error("cannot create a pipe: " + system_reason());
  return {above_standard_streams(Descriptor(ends[0])), above_standard_streams(Descriptor(ends[1]))};
}

pid_t launch(const Launch& wanted) {
  PreparedLaunch ready = prepare(wanted);
  Pipe error_pipe = make_pipe();
  ready.error_pipe = error_pipe.write.get();

  // If we inherited an ignored SIGCHLD, the system would discard the child's exit status.
  struct sigaction action {};
  if (::sigaction(SIGCHLD, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) ::signal(SIGCHLD, SIG_DFL);

  const pid_t child = ::fork();
  if (child == 0) exec_child(ready);
  int reason = errno;
  error_pipe.write.reset();
  if (child > 0) {
    ::setpgid(child, child);  // parent and child both do this, so that the group exists from here on
    ssize_t got;
    do got = ::read(error_pipe.read.get(), &reason, sizeof reason);
    while (got < 0 && errno == EINTR);
    if (got == 0) return child;  // exec closed the pipe
    ::waitpid(child, nullptr, 0);
  }
  throw Error(fmt::format("program '{}' cannot be started: {}", wanted.arguments.front(), system_reason(reason)));
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
