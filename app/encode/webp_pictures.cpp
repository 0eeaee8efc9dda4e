// SPDX-License-Identifier: MIT
#include "app/encode/webp_pictures.h"

#include "app/encode/ffmpeg.h"

#include <cmath>

namespace flipbook::app {

namespace {

Words codec(const VideoSettings& s) {
  return {"-c:v", "libwebp", "-quality", std::to_string(picture_quality(s.crf)), "-compression_level", "6"};
}

} // namespace

int picture_quality(int crf) {
  return static_cast<int>(std::lround(100 - 1.4 * crf));
}

std::unique_ptr<Sink> webp_pictures(const std::filesystem::path& folder, const std::string& prefix,
                                    const VideoSettings& s) {
  const Words several{"-f", "image2", "-start_number", "0"};
  return std::make_unique<FfmpegFile>(folder / (prefix + "0000.webp"), s, joined({codec(s), several}),
                                      prefix + "%04d.webp");
}

std::unique_ptr<Sink> webp_picture(const std::filesystem::path& file, const VideoSettings& s) {
  return std::make_unique<FfmpegFile>(
      file, s, joined({{"-vf", animation_scale(s)}, codec(s), {"-frames:v", "1", "-f", "webp"}}));
}

} // namespace flipbook::app
