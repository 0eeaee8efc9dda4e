// SPDX-License-Identifier: MIT
#include "app/encode/ffmpeg.h"

#include "sim/frame/errors.h"
#include "sim/frame/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

/// What every run of it begins with: no questions, only errors are told, and the first one ends it.
const Words quiet{"-nostdin", "-hide_banner", "-loglevel", "error", "-xerror", "-y"};

/// No identifiers, dates or versions.
const Words same_bytes{"-fflags", "+bitexact", "-flags:v", "+bitexact"};

/// The input: pictures of that size and rate from the pipe.
Words raw_pictures(const VideoSettings& s) {
  const std::string size = std::to_string(s.width) + "x" + std::to_string(s.height);
  return {"-f", "rawvideo", "-pix_fmt", "rgba", "-video_size", size, "-framerate", to_toml(Value(s.fps)),
          "-i", "pipe:0"};
}

} // namespace

Words joined(std::initializer_list<Words> parts) {
  Words all;
  for (const Words& p : parts) all.insert(all.end(), p.begin(), p.end());
  return all;
}

fs::path find_ffmpeg() {
  if (auto found = Process::find("ffmpeg")) return *found;
  const char* path = std::getenv("PATH");
  throw MachineError("no ffmpeg, which makes " + video_extensions(" and ") + " files, in PATH (" +
                     std::string(path ? path : "not set") +
                     "): install it (apt install ffmpeg) or write PNG frames with -o FOLDER/");
}

Words bt709() {
  return {"-vf",
          "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "bt709",
          "-color_range",
          "tv"};
}

Words metadata(const VideoSettings& s) {
  return {"-metadata", "title=" + s.title, "-metadata", "comment=" + s.comment};
}

std::string told(const VideoSettings& s) {
  return s.title + (s.comment.empty() ? "" : "\n\n" + s.comment);
}

std::string animation_scale(const VideoSettings& s) {
  const int width = std::min(s.width, s.animation_width);
  const auto height = std::max(1L, std::lround(static_cast<double>(s.height) * width / s.width));
  return "scale=" + std::to_string(width) + ":" + std::to_string(height) +
         ":flags=lanczos+accurate_rnd+full_chroma_int";
}

std::string animation_filters(const VideoSettings& s) {
  // A video of less than half an interval still has its picture: eof_action.
  return "fps=" + to_toml(Value(std::min(s.fps, s.animation_fps))) + ":eof_action=pass," + animation_scale(s);
}

FfmpegFile::FfmpegFile(const fs::path& file, const VideoSettings& s, const Words& encoding, const std::string& name)
    : path_(file), staging_(file.parent_path()),
      encoder_(find_ffmpeg(), joined({quiet, raw_pictures(s), encoding, same_bytes, {staged(name)}})), width_(s.width),
      height_(s.height) {}

void FfmpegFile::write(const Picture& picture) {
  if (picture.image.width != width_ || picture.image.height != height_) // it would be cut, and shift all that follow
    throw std::logic_error("a picture of another size for " + path_.string());
  if (encoder_.write(picture.image.rgba)) return;
  const std::string how = encoder_.finish();
  check(how.empty() ? "exit code 0" : how);
}

void FfmpegFile::finish() {
  check(encoder_.finish());
}

void FfmpegFile::run(const Words& arguments) const {
  Process process(find_ffmpeg(), joined({quiet, arguments}));
  check(process.finish());
}

void FfmpegFile::rewrite(const std::function<std::string(std::string_view bytes)>& change) const {
  std::ifstream in(staged(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw MachineError("cannot read " + path_.string() + " again");
  staging_.write(path_.filename().string(), change(bytes));
}

std::string FfmpegFile::staged(const std::string& name) const {
  return staging_.file(name.empty() ? path_.filename().string() : name).string();
}

void FfmpegFile::check(const std::string& how) const {
  if (!how.empty()) throw MachineError("cannot write " + path_.string() + ": ffmpeg stopped with " + how);
}

} // namespace flipbook::app
