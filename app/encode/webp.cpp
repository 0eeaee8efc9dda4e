// SPDX-License-Identifier: MIT
// Animated WebP: every browser shows it as a picture, without a player.
#include "app/encode/ffmpeg.h"
#include "app/encode/picture_text.h"
#include "app/encode/webp_pictures.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

class WebpFile final : public FfmpegFile {
public:
  WebpFile(const std::filesystem::path& file, const VideoSettings& s)
      : FfmpegFile(file, s,
                   {"-vf", animation_filters(s), "-c:v", "libwebp_anim", "-quality",
                    std::to_string(picture_quality(s.crf)), "-compression_level", "4", "-loop", "0", "-f", "webp"}),
        text_(told(s)), least_(static_cast<int>(std::ceil(2 * s.fps / std::min(s.fps, s.animation_fps)))) {}

  void write(const Picture& picture) override {
    FfmpegFile::write(picture);
    if (++written_ < least_) last_ = picture;
  }
  void finish() override {
    for (; 0 < written_ && written_ < least_; ++written_) FfmpegFile::write(last_);
    FfmpegFile::finish();
    rewrite([this](std::string_view bytes) { return with_webp_description(bytes, text_); });
  }

private:
  std::string text_;
  int written_ = 0, least_; ///< the encoder makes no animation of fewer than two frames
  Picture last_;
};

} // namespace

int picture_quality(int crf) {
  return static_cast<int>(std::lround(100 - 1.4 * crf));
}

std::unique_ptr<Sink> webp_file(const std::filesystem::path& file, const VideoSettings& s) {
  return std::make_unique<WebpFile>(file, s);
}

} // namespace flipbook::app
