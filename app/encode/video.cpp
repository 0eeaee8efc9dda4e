// SPDX-License-Identifier: MIT
#include "app/encode/video.h"

#include "app/encode/process.h"
#include "app/encode/staging.h"
#include "sim/frame/errors.h"
#include "sim/frame/parameters.h"

#include <cstdlib>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

fs::path find_ffmpeg() {
  if (auto found = Process::find("ffmpeg")) return *found;
  const char* path = std::getenv("PATH");
  throw MachineError("no ffmpeg, which makes the videos, in PATH (" + std::string(path ? path : "not set") +
                     "): install it (apt install ffmpeg) or write PNG frames with -o FOLDER/");
}

std::vector<std::string> arguments(const VideoFormat& f, const fs::path& file) {
  const std::string size = std::to_string(f.width) + "x" + std::to_string(f.height);
  return {"-nostdin", "-hide_banner", "-loglevel", "error", "-xerror", "-y", "-f", "rawvideo", "-pix_fmt", "rgba",
          "-video_size", size, "-framerate", to_toml(Value(f.fps)), "-i", "pipe:0",
          // Players take untagged HD video for BT.709, ffmpeg converts to BT.601 unless told: say it in both places.
          "-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p",
          "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv", "-c:v",
          "libx264", "-preset", "veryfast", "-crf", std::to_string(f.crf), "-threads", "2", "-metadata",
          "title=" + f.title, "-metadata", "comment=" + f.comment, "-fflags", "+bitexact", "-flags:v", "+bitexact",
          "-movflags", "+faststart", "-f", "mp4", file.string()};
}

class VideoFile final : public Sink {
public:
  VideoFile(const fs::path& file, const VideoFormat& f)
      : path_(file), staging_(file.parent_path()), name_(file.filename().string()),
        encoder_(find_ffmpeg(), arguments(f, staging_.file(name_))) {}

  void write(const Picture& picture) override {
    if (!encoder_.write(picture.image.rgba)) fail(encoder_.finish());
  }
  void finish() override {
    if (const std::string error = encoder_.finish(); !error.empty()) fail(error);
  }
  void commit() override { staging_.commit(); }
  [[nodiscard]] fs::path path() const override { return path_; }
  [[nodiscard]] bool computes() const override { return false; } // ffmpeg has its own, fixed number of threads

private:
  [[noreturn]] void fail(const std::string& how) const {
    throw MachineError("cannot write " + path_.string() + ": ffmpeg stopped with " +
                       (how.empty() ? "exit code 0" : how));
  }

  fs::path path_;
  Staging staging_;
  std::string name_;
  Process encoder_;
};

} // namespace

std::unique_ptr<Sink> video_file(const fs::path& file, const VideoFormat& format) {
  if (format.width % 2 != 0 || format.height % 2 != 0)
    throw UserError("a video needs an even width and height (H.264, yuv420p), not " + std::to_string(format.width) +
                    "x" + std::to_string(format.height));
  return std::make_unique<VideoFile>(file, format);
}

} // namespace flipbook::app
