#include "running.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <sstream>

#include "base/launch.hpp"
#include "catch.hpp"
#include "command.hpp"

namespace atelier::test {

namespace fs = std::filesystem;

namespace {

std::string text_of_process(const fs::path& process, const char* file) {
  try {
    return read_file(process / file);
  } catch (const Error&) {
    return "";  // it has ended, or is the system's
  }
}

/// Calls visit(folder in /proc) for each process.
template <class Visit>
void for_processes(Visit visit) {
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error))
    if (entry->path().filename().string().find_first_not_of("0123456789") == std::string::npos) visit(entry->path());
}

}  // namespace

Running::Running(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment) {
  const Descriptor file(::open((printed_.path() / "output").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
  process_ = launch({.arguments = arguments,
                     .folder = folders().root,
                     .environment = environment,
                     .descriptors = {{file.get(), 1}, {file.get(), 2}}});
}

Running::~Running() {
  kill();
}

bool Running::runs() {
  if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
  return process_ > 0;
}

void Running::kill() {
  if (process_ > 0) status_ = kill_and_wait(process_);
  process_ = -1;
}

void Running::signal(int number) const {
  if (process_ > 0) ::kill(process_, number);
}

int Running::wait() {
  INFO(output());
  REQUIRE(comes_true([&] { return !runs(); }, 300));
  return WIFSIGNALED(status_) ? -WTERMSIG(status_) : WEXITSTATUS(status_);
}

std::string Running::output() const {
  return read_file(printed_.path() / "output");
}

std::vector<pid_t> Running::children() const {
  std::vector<pid_t> found;
  for_processes([&](const fs::path& process) {
    const std::string stat = text_of_process(process, "stat");  // "12 (name) S PARENT ..."
    std::istringstream after_name(stat.substr(std::min(stat.rfind(')') + 1, stat.size())));
    std::string state;
    pid_t parent = 0;
    if (after_name >> state >> parent && parent == process_ && state != "Z")
      found.push_back(std::stoi(process.filename().string()));
  });
  return found;
}

void pause_shortly() {
  ::poll(nullptr, 0, 5);
}

std::vector<FoundProcess> processes_with(const std::string& text) {
  std::vector<FoundProcess> found;
  for_processes([&](const fs::path& process) {
    for (const char* file : {"cmdline", "environ"})
      if (std::string words = text_of_process(process, file); words.find(text) != words.npos) {
        std::ranges::replace(words, '\0', ' ');
        found.push_back({std::stoi(process.filename().string()), words.substr(0, 300)});
        return;
      }
  });
  return found;
}

}  // namespace atelier::test
