// SPDX-License-Identifier: MIT
// Animated GIF with one palette made for the whole animation. That takes three runs of ffmpeg: the pictures, already as
// small as they will be, into a file without loss; the palette from all of them; and the animation. One run would have
// to hold every picture in memory until the last had come.
#include "app/encode/ffmpeg.h"
#include "app/encode/picture_text.h"

namespace flipbook::app {

namespace {

constexpr const char* pictures = "pictures.nut";
constexpr const char* palette = "palette.png";

class GifFile final : public FfmpegFile {
public:
  GifFile(const std::filesystem::path& file, const VideoSettings& s)
      : FfmpegFile(file, s,
                   {"-vf", animation_filters(s), "-c:v", "ffv1", "-pix_fmt", "bgr0", "-threads", "1", "-f", "nut"},
                   pictures),
        text_(told(s)) {}

  void finish() override {
    FfmpegFile::finish();
    run({"-i", staged(pictures), "-vf", "palettegen=stats_mode=full", "-frames:v", "1", "-update", "1",
         staged(palette)});
    // An ordered pattern stands still where the picture does; errors that are passed on would swarm and cost bytes.
    run({"-i", staged(pictures), "-i", staged(palette), "-lavfi",
         "paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle", "-loop", "0", "-fflags", "+bitexact", "-f", "gif",
         staged()});
    rewrite([this](std::string_view bytes) { return with_gif_comment(bytes, text_); });
    std::filesystem::remove(staged(pictures));
    std::filesystem::remove(staged(palette));
  }

private:
  std::string text_;
};

} // namespace

std::unique_ptr<Sink> gif_file(const std::filesystem::path& file, const VideoSettings& s) {
  return std::make_unique<GifFile>(file, s);
}

} // namespace flipbook::app
