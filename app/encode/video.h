// SPDX-License-Identifier: MIT
// An H.264 video (yuv420p, fast start) made by the ffmpeg program, which reads raw pictures from a pipe.
#pragma once

#include "app/encode/sink.h"

#include <filesystem>
#include <memory>

namespace flipbook::app {

struct VideoFormat {
  int width = 0, height = 0; ///< even: yuv420p has half as many colour samples on each axis
  double fps = 30;
  int crf = 18;
  std::string title, comment; ///< metadata; the comment holds the study
};

/// Throws MachineError when there is no ffmpeg or nothing can be written beside `file`, UserError for an odd size.
[[nodiscard]] std::unique_ptr<Sink> video_file(const std::filesystem::path& file, const VideoFormat& format);

} // namespace flipbook::app
