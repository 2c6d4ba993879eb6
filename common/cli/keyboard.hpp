// Keys as they are pressed: without Enter, and without their letters on the screen.
#pragma once

#include <optional>

namespace atelier {

/// Takes over the terminal on standard input, and gives it back at the end of its scope, when a signal ends or stops
/// the program, and takes it again when the program goes on. There is one at a time. Where standard input is no
/// terminal, bytes are taken as they come.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  int descriptor() const { return 0; }
  /// The next key, if one has been pressed. Never waits.
  std::optional<char> take();
  /// No key will ever come: the terminal was closed, or the file has been read to its end.
  bool closed() const { return closed_; }

 private:
  bool closed_ = false;
};

}  // namespace atelier
