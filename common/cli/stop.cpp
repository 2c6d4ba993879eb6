#include "cli/stop.hpp"

#include <iterator>

namespace atelier {
namespace {

constexpr int stopping_signals[] = {SIGINT, SIGTERM, SIGHUP};
volatile sig_atomic_t received = 0;

void receive(int number) {
  if (received != 0) {
    ::signal(number, SIG_DFL);
    ::raise(number);  // takes effect when this handler returns
  }
  received = number;
}

}  // namespace

StopOnSignal::StopOnSignal() {
  received = 0;
  struct sigaction action {};
  action.sa_handler = receive;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < std::size(stopping_signals); ++i) {
    ::sigaction(stopping_signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(stopping_signals[i], &action, nullptr);
  }
}

StopOnSignal::~StopOnSignal() {
  for (std::size_t i = 0; i < std::size(stopping_signals); ++i) ::sigaction(stopping_signals[i], &before_[i], nullptr);
  if (received != 0) ::raise(received);
}

bool StopOnSignal::requested() const {
  return received != 0;
}

}  // namespace atelier
