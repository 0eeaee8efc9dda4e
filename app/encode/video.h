// SPDX-License-Identifier: MIT
// The files that the frames of a run become, apart from PNG pictures. The ffmpeg program makes them: it reads raw
// pictures from a pipe. A format is one file, and one line in video.cpp.
#pragma once

#include "app/encode/sink.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace flipbook::app {

struct VideoSettings {
  int width = 0, height = 0;
  double fps = 30;
  int crf = 18;              ///< quality on the scale of H.264: 0 without loss, 51 worst
  int animation_width = 640; ///< at most so wide are the formats for slides and pages (GIF, WebP)
  double animation_fps = 12.5;
  std::string title, comment; ///< metadata; the comment holds the study
};

struct VideoFormat {
  std::string_view extension; ///< ".mp4"
  std::string_view help;      ///< one sentence
  bool even;                  ///< yuv420p has half as many colour samples on each axis
  std::unique_ptr<Sink> (*open)(const std::filesystem::path& file, const VideoSettings& settings);
};

/// All formats, the usual one first.
[[nodiscard]] std::span<const VideoFormat> video_formats();
/// ".mp4, .webm, .gif or .webp"
[[nodiscard]] std::string video_extensions(std::string_view between_last = " or ");
/// Null: nothing has this extension.
[[nodiscard]] const VideoFormat* find_video_format(std::string_view extension);

/// A file of the format. Throws MachineError when there is no ffmpeg or nothing can be written beside `file`, UserError
/// for an odd size where the format wants an even one.
[[nodiscard]] std::unique_ptr<Sink> video_file(const VideoFormat& format, const std::filesystem::path& file,
                                               const VideoSettings& settings);
/// An H.264 video.
[[nodiscard]] std::unique_ptr<Sink> video_file(const std::filesystem::path& file, const VideoSettings& settings);

// === The formats, a file each

[[nodiscard]] std::unique_ptr<Sink> mp4_file(const std::filesystem::path& file, const VideoSettings& settings);
[[nodiscard]] std::unique_ptr<Sink> webm_file(const std::filesystem::path& file, const VideoSettings& settings);
[[nodiscard]] std::unique_ptr<Sink> gif_file(const std::filesystem::path& file, const VideoSettings& settings);
[[nodiscard]] std::unique_ptr<Sink> webp_file(const std::filesystem::path& file, const VideoSettings& settings);

} // namespace flipbook::app
