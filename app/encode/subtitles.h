// SPDX-License-Identifier: MIT
// Subtitles as WebVTT (https://www.w3.org/TR/webvtt1/), which players and browsers show over a video.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

struct Cue {
  double from = 0, to = 0;        ///< seconds of video
  std::vector<std::string> lines; ///< plain text

  bool operator==(const Cue&) const = default;
};

/// The whole file. `<`, `&` and `>` are escaped, and no line of a cue is empty, as an empty one would end it.
[[nodiscard]] std::string to_vtt(std::span<const Cue> cues);

} // namespace flipbook::app
