#include "cli/stop.hpp"

#include <iterator>

namespace atelier {
namespace {

constexpr int stopping_signals[] = {SIGINT, SIGTERM, SIGHUP};
volatile sig_atomic_t taken = 0;

void take(int number) {
  if (taken != 0) {
    ::signal(number, SIG_DFL);
    ::raise(number);  // at once, when this handler returns
  }
  taken = number;
}

}  // namespace

StopOnSignal::StopOnSignal() {
  taken = 0;
  struct sigaction action {};
  action.sa_handler = take;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < std::size(stopping_signals); ++i) {
    ::sigaction(stopping_signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(stopping_signals[i], &action, nullptr);
  }
}

StopOnSignal::~StopOnSignal() {
  for (std::size_t i = 0; i < std::size(stopping_signals); ++i) ::sigaction(stopping_signals[i], &before_[i], nullptr);
  if (taken != 0) ::raise(taken);
}

bool StopOnSignal::asked() const {
  return taken != 0;
}

}  // namespace atelier
