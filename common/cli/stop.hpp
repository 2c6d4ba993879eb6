// Handles Ctrl-C while step programs run: they are killed and temporary files are deleted before this program ends.
// `watch` reads the keyboard instead (cli/student/keyboard.hpp).
#pragma once

#include <signal.h>

namespace atelier {

/// From its construction, the first SIGINT, SIGTERM or SIGHUP only requests a stop; a second one ends the program at
/// once. A signal that was ignored at start stays ignored. Create it before the objects that must be cleaned up, and
/// only one at a time. The destructor raises the received signal again, so that the parent process sees what ended this
/// program.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  bool requested() const;

 private:
  struct sigaction before_[3];
};

}  // namespace atelier
