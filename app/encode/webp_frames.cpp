// SPDX-License-Identifier: MIT
#include "app/encode/webp_frames.h"

#include "app/encode/ffmpeg.h"

namespace flipbook::app {

std::unique_ptr<Sink> webp_frames(const std::filesystem::path& folder, const std::string& prefix,
                                  const VideoSettings& settings, int quality) {
  const Words codec{"-c:v", "libwebp", "-quality", std::to_string(quality), "-compression_level",
                    "4",    "-f",      "image2",   "-start_number",         "0"};
  return std::make_unique<FfmpegFile>(folder / (prefix + "0000.webp"), settings, codec, prefix + "%04d.webp");
}

} // namespace flipbook::app
