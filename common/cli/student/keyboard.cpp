#include "cli/student/keyboard.hpp"

#include <poll.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

namespace atelier {
namespace {

termios usual, bare;                // how the terminal was, and how it is while we listen
bool ours = false;                  // whether it is as `bare` says
volatile sig_atomic_t leaving = 0;  // the signal that has asked us to end
constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

// In these handlers: only calls that POSIX calls async-signal-safe; tcsetattr is among them.

/// In the background the terminal is not ours to change: asking would stop us.
bool in_foreground() {
  return ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
}

void give_back() {
  if (ours && in_foreground()) ::tcsetattr(STDIN_FILENO, TCSADRAIN, &usual);
}

/// Ends or stops the program as if nobody had listened to the signal.
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
  ::sigprocmask(SIG_UNBLOCK, &just_this, nullptr);  // here the program ends, or stops and later goes on
  ::sigaction(number, &mine, nullptr);
  errno = error;
}

/// The first time only taken down, so that whoever listens can end its programs and take its files away.
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
  if (::tcgetattr(STDIN_FILENO, &usual) != 0) return;  // no terminal
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
  if (leaving != 0) ::raise(leaving);  // whoever waits for us is to know what ended us
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
