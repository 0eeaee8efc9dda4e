// SPDX-License-Identifier: MIT
// Animated WebP: every browser shows it as a picture, without a player.
#include "app/encode/ffmpeg.h"
#include "app/encode/picture_text.h"
#include "app/encode/webp_pictures.h"

namespace flipbook::app {

namespace {

class WebpFile final : public FfmpegFile {
public:
  WebpFile(const std::filesystem::path& file, const VideoSettings& s)
      : FfmpegFile(file, s,
                   {"-vf", animation_filters(s), "-c:v", "libwebp_anim", "-quality",
                    std::to_string(picture_quality(s.crf)), "-compression_level", "4", "-loop", "0", "-f", "webp"}),
        text_(told(s)) {}

  void finish() override {
    FfmpegFile::finish();
    rewrite([this](std::string_view bytes) { return with_webp_description(bytes, text_); });
  }

private:
  std::string text_;
};

} // namespace

std::unique_ptr<Sink> webp_file(const std::filesystem::path& file, const VideoSettings& s) {
  return std::make_unique<WebpFile>(file, s);
}

} // namespace flipbook::app
