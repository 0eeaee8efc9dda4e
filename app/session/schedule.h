// SPDX-License-Identifier: MIT
// When a run stops to be looked at. Frame k is at k scale / fps, computed from k, never accumulated. Stills stop at the
// same frames (so that a still equals the frame of the video at its time) and exactly at the times asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace flipbook::app {

struct Stop {
  std::uint64_t frame = 0; ///< the last frame boundary reached
  double time = 0;         ///< seconds simulated
  bool boundary = true;    ///< is it a frame boundary, where commands take effect?
  bool shown = true;       ///< does a picture come of it?
};

class Schedule {
public:
  /// `frames` frames; `scale` simulated seconds pass in a second of video.
  [[nodiscard]] static Schedule video(double fps, double scale, std::uint64_t frames);
  /// One picture for each time, up to the last.
  [[nodiscard]] static Schedule stills(double fps, double scale, std::vector<double> times);

  /// Frames at times that follow no rule; `shown` holds the numbers of those that become pictures.
  [[nodiscard]] static Schedule listed(const std::vector<double>& times, const std::vector<std::size_t>& shown);

  [[nodiscard]] std::optional<Stop> next();
  [[nodiscard]] std::uint64_t pictures() const { return pictures_; }
  [[nodiscard]] std::uint64_t boundaries() const; ///< frame boundaries that the run comes to

private:
  Schedule(double fps, double scale) : fps_(fps), scale_(scale) {}
  [[nodiscard]] double time_of(std::uint64_t frame) const { return static_cast<double>(frame) * scale_ / fps_; }

  double fps_, scale_;
  std::uint64_t pictures_ = 0;
  std::uint64_t frame_ = 0; ///< the next boundary
  bool stills_ = false;
  std::vector<double> times_; ///< sorted, without repetition
  std::size_t at_ = 0;        ///< the next of them
  std::vector<Stop> listed_;  ///< if there are any: instead of all that
};

} // namespace flipbook::app
