// Reads single keys: without Enter and without echo.
#pragma once

#include <optional>

namespace atelier {

/// Changes the settings of the terminal on standard input; restores them at the end of its scope and while the program
/// is stopped. A terminating signal (Ctrl-C) makes it `closed`, and ends the program at the end of its scope; a second
/// one ends it at once. Only one may exist. If standard input is not a terminal, it reads bytes.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  int descriptor() const { return 0; }
  /// The next key, if one was pressed. Does not wait.
  std::optional<char> take();
  /// No more keys will come: end of file, the terminal was closed, or a signal requested termination.
  bool closed() const;

 private:
  bool closed_ = false;
};

}  // namespace atelier
