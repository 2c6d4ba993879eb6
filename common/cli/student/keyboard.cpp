#include "cli/student/keyboard.hpp"

#include <poll.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

namespace atelier {
namespace {

termios usual, bare;                // the terminal's settings before and while we read keys
bool ours = false;                  // whether `bare` is active
volatile sig_atomic_t leaving = 0;  // the signal that requested termination
constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

// In these handlers: only calls that POSIX calls async-signal-safe; tcsetattr is among them.

/// A background process must not change the terminal: it would be stopped.
bool in_foreground() {
  return ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
}

void give_back() {
  if (ours && in_foreground()) ::tcsetattr(STDIN_FILENO, TCSADRAIN, &usual);
}

/// Performs the signal's default action: ends or stops the program.
void leave_at_once(int number) {
  const int error = errno;
  give_back();
  struct sigaction usual_action {
  }, mine{};
  usual_action.sa_handler = SIG_DFL;
  ::sigaction(number, &usual_action, &mine);
  sigset_t just_this;
  sigemptyset(&just_this);
  sigaddset(&just_this, number);
  ::raise(number);
  ::sigprocmask(SIG_UNBLOCK, &just_this, nullptr);  // here the program ends, or stops and continues later
  ::sigaction(number, &mine, nullptr);
  errno = error;
}

/// The first signal is only stored, so that the program can clean up.
void leave(int number) {
  if (leaving != 0) leave_at_once(number);
  leaving = number;
}

void come_back(int) {
  const int error = errno;
  if (ours && in_foreground()) ::tcsetattr(STDIN_FILENO, TCSADRAIN, &bare);
  errno = error;
}

void on_signal(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(number, &action, nullptr);
}

}  // namespace

Keyboard::Keyboard() {
  if (::tcgetattr(STDIN_FILENO, &usual) != 0) return;  // not a terminal
  bare = usual;
  bare.c_lflag &= ~tcflag_t(ICANON | ECHO);
  bare.c_cc[VMIN] = 0, bare.c_cc[VTIME] = 0;
  ours = true;
  for (const int number : ending_signals) on_signal(number, leave);
  on_signal(SIGTSTP, leave_at_once);
  on_signal(SIGCONT, come_back);
  ::tcsetattr(STDIN_FILENO, TCSADRAIN, &bare);
}

Keyboard::~Keyboard() {
  if (!ours) return;
  give_back();
  ours = false;
  for (const int number : ending_signals) on_signal(number, SIG_DFL);
  on_signal(SIGTSTP, SIG_DFL);
  on_signal(SIGCONT, SIG_DFL);
  if (leaving != 0) ::raise(leaving);  // so that the parent process sees the signal
}

bool Keyboard::closed() const {
  return closed_ || leaving != 0;
}

std::optional<char> Keyboard::take() {
  pollfd entry{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (closed_ || ::poll(&entry, 1, 0) != 1) return {};
  char key = 0;
  const ssize_t got = ::read(STDIN_FILENO, &key, 1);
  if (got == 1) return key;
  closed_ = got == 0 || (errno != EAGAIN && errno != EINTR);
  return {};
}

}  // namespace atelier
