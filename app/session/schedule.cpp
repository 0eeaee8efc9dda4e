// SPDX-License-Identifier: MIT
#include "app/session/schedule.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

Schedule Schedule::video(double fps, double scale, std::uint64_t frames) {
  Schedule s(fps, scale);
  s.pictures_ = frames;
  return s;
}

Schedule Schedule::stills(double fps, double scale, std::vector<double> times) {
  Schedule s(fps, scale);
  s.stills_ = true;
  // A time that is a frame's but for the rounding of k scale / fps means that frame.
  for (double& t : times) {
    const double k = std::round(t / scale * fps);
    if (std::abs(t / scale * fps - k) < 1e-9 * std::max(1.0, k)) t = s.time_of(static_cast<std::uint64_t>(k));
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  s.times_ = std::move(times);
  s.pictures_ = s.times_.size();
  return s;
}

Schedule Schedule::listed(const std::vector<double>& times, const std::vector<std::size_t>& shown) {
  Schedule s(1, 1);
  for (std::size_t k = 0; k < times.size(); ++k)
    s.listed_.push_back({k, times[k], true, std::find(shown.begin(), shown.end(), k) != shown.end()});
  while (!s.listed_.empty() && !s.listed_.back().shown) s.listed_.pop_back();
  for (const Stop& stop : s.listed_) s.pictures_ += stop.shown ? 1 : 0;
  return s;
}

std::uint64_t Schedule::boundaries() const {
  if (!listed_.empty()) return listed_.size();
  if (!stills_) return pictures_;
  if (times_.empty()) return 0;
  auto k = static_cast<std::uint64_t>(times_.back() / scale_ * fps_) + 1; // but for rounding
  while (time_of(k) <= times_.back()) ++k;
  return k;
}

std::optional<Stop> Schedule::next() {
  if (!listed_.empty()) return frame_ < listed_.size() ? std::optional(listed_[frame_++]) : std::nullopt;
  if (!stills_) {
    if (frame_ == pictures_) return std::nullopt;
    const std::uint64_t k = frame_++;
    return Stop{k, time_of(k), true, true};
  }
  if (at_ == times_.size()) return std::nullopt;
  const double t = times_[at_];
  if (time_of(frame_) <= t) {
    const std::uint64_t k = frame_++;
    const bool asked = time_of(k) == t;
    if (asked) ++at_;
    return Stop{k, time_of(k), true, asked};
  }
  ++at_;
  return Stop{frame_ - 1, t, false, true};
}

} // namespace flipbook::app
