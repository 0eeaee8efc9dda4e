// SPDX-License-Identifier: MIT
#include "app/session/progress.h"

#include <cstdio>
#include <unistd.h>

namespace flipbook::app {

namespace {

std::string minutes(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld", s / 60, s % 60);
  return text;
}

} // namespace

Progress::Progress(std::uint64_t frames, bool quiet)
    : frames_(frames), visible_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) show("");
}

void Progress::update(std::uint64_t frames_done, std::uint64_t particle_steps) {
  const Clock::time_point now = Clock::now();
  if (!visible_ || frames_done == 0 || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const double left = spent * static_cast<double>(frames_ - frames_done) / static_cast<double>(frames_done);
  char text[160];
  std::snprintf(text, sizeof text, "frame %llu of %llu   %.2f million particle-steps/s   %s left",
                static_cast<unsigned long long>(frames_done), static_cast<unsigned long long>(frames_),
                1e-6 * static_cast<double>(particle_steps) / spent, minutes(left).c_str());
  show(text);
}

void Progress::show(const std::string& line) {
  drawn_ = true;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
}

} // namespace flipbook::app
