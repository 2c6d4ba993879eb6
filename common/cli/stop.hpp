// Ctrl-C while the programs of somebody's step run: they are ended, and what was written for them is taken away, before
// this program ends. `watch` has the keyboard for it (cli/student/keyboard.hpp).
#pragma once

#include <signal.h>

namespace atelier {

/// From when it is made, the first SIGINT, SIGTERM or SIGHUP only asks to stop; a second one ends the program at once.
/// One that this program was started to ignore stays ignored.
/// Make it before whatever must be taken away, and one at a time: at the end of its scope the signal does what it was
/// held back from, so that whoever waits for this program knows what ended it.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  bool asked() const;

 private:
  struct sigaction before_[3];
};

}  // namespace atelier
