// SPDX-License-Identifier: MIT
// The progress line on a terminal: frames, particle-steps per second, time left. Silent elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace flipbook::app {

class Progress {
public:
  Progress(std::uint64_t frames, bool quiet);
  ~Progress(); ///< takes the line away

  void update(std::uint64_t frames_done, std::uint64_t particle_steps);

private:
  using Clock = std::chrono::steady_clock;
  void show(const std::string& line);

  std::uint64_t frames_;
  bool visible_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

} // namespace flipbook::app
