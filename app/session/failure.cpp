// SPDX-License-Identifier: MIT
#include "app/session/failure.h"

#include <csignal>

namespace flipbook::app {

namespace {

std::atomic<int> received{0}; // lock-free, so that a signal handler may write it

} // namespace

void catch_signals() {
  for (const int s : {SIGINT, SIGTERM, SIGHUP})
    std::signal(s, [](int signal) {
      received = signal;
      std::signal(signal, SIG_DFL); // a second one ends the program as usual
    });
}

int signal_received() {
  return received;
}

} // namespace flipbook::app
