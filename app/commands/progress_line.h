// SPDX-License-Identifier: MIT
// Shows how far something is, on a terminal only.
#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

namespace flipbook::app {

class ProgressLine {
public:
  explicit ProgressLine(std::string name) : name_(std::move(name)), terminal_(isatty(STDERR_FILENO) == 1) {}
  ~ProgressLine() {
    if (terminal_) std::fprintf(stderr, "\r\033[K");
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(std::size_t done, std::size_t of) const {
    if (terminal_) std::fprintf(stderr, "\r\033[K%s: run %zu of %zu", name_.c_str(), done, of);
  }

private:
  std::string name_;
  bool terminal_;
};

} // namespace flipbook::app
