// Keys as they are pressed: without Enter, and without their letters on the screen.
#pragma once

#include <optional>

namespace atelier {

/// Takes over the terminal on standard input, and gives it back at the end of its scope and while the program is
/// stopped. A signal that asks the program to end (Ctrl-C) makes it `closed`, and ends the program at the end of its
/// scope; a second one does so at once. There is one at a time. Where standard input is no terminal, bytes are taken as
/// they come.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  int descriptor() const { return 0; }
  /// The next key, if one has been pressed. Never waits.
  std::optional<char> take();
  /// No key will ever come: the terminal was closed, the file has been read to its end, or we are asked to leave.
  bool closed() const;

 private:
  bool closed_ = false;
};

}  // namespace atelier
