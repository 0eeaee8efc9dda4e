// SPDX-License-Identifier: MIT
// H.264 in MP4, its index first so that it plays while it loads.
#include "app/encode/ffmpeg.h"

namespace flipbook::app {

std::unique_ptr<Sink> mp4_file(const std::filesystem::path& file, const VideoSettings& s) {
  const Words codec{"-c:v",     "libx264", "-preset",   "veryfast",   "-crf", std::to_string(s.crf),
                    "-threads", "2",       "-movflags", "+faststart", "-f",   "mp4"};
  return std::make_unique<FfmpegFile>(file, s, joined({bt709(), codec, metadata(s)}));
}

} // namespace flipbook::app
