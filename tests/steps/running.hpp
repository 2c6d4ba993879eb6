// Programs that are watched and killed while they run.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "base/stopwatch.hpp"

namespace atelier::test {

/// A command that runs: it can be watched and killed.
class Running {
 public:
  Running(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment);
  ~Running();  ///< kills it, if it runs
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool runs();
  void kill();                    ///< with its process group, by SIGKILL
  void signal(int number) const;  ///< to it alone
  int wait();                     ///< for its end, at most 300 s; its exit status, or minus the signal that ended it
  std::string output() const;
  std::vector<pid_t> children() const;  ///< processes that it has started, and that run

 private:
  TemporaryFolder printed_{"atelier-steps-test"};
  pid_t process_ = -1;
  int status_ = 0;
};

void pause_shortly();  ///< 5 ms

/// Waits at most `seconds` until `holds`; returns whether it does.
template <class Condition>
bool comes_true(Condition holds, double seconds = 60) {
  const Stopwatch watch;
  while (!holds())
    if (watch.seconds() > seconds)
      return false;
    else
      pause_shortly();
  return true;
}

/// A process, and its command or environment with spaces between the words.
struct FoundProcess {
  pid_t number = 0;
  std::string words;
};

/// The processes in whose command or environment a text stands. Of those that have ended and not been waited for there
/// is neither.
std::vector<FoundProcess> processes_with(const std::string& text);

}  // namespace atelier::test
