// SPDX-License-Identifier: MIT
// The first failure of a run with several threads, and the request to stop that goes with it.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>

namespace flipbook::app {

/// The user pressed Ctrl-C, or the machine asked us to end.
class Interrupted : public std::runtime_error {
public:
  explicit Interrupted(int s) : std::runtime_error("interrupted"), signal(s) {}
  int signal;
};

class Failure {
public:
  /// Keeps the exception if it is the first one.
  void report(std::exception_ptr e) {
    const std::scoped_lock lock(mutex_);
    if (!first_) first_ = e;
    failed_ = true;
  }
  [[nodiscard]] bool failed() const { return failed_; }
  void rethrow() {
    const std::scoped_lock lock(mutex_);
    if (first_) std::rethrow_exception(first_);
  }

private:
  std::mutex mutex_;
  std::exception_ptr first_;
  std::atomic<bool> failed_{false};
};

/// From here on Ctrl-C and a request to terminate are noted instead of ending the program at once.
void catch_signals();
/// The signal that came, or 0.
[[nodiscard]] int signal_received();

} // namespace flipbook::app
