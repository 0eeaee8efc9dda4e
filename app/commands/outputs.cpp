// SPDX-License-Identifier: MIT
#include "app/commands/outputs.h"

#include "app/encode/beside.h"
#include "app/encode/png.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <filesystem>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

/// The lower-case extension of a file's name; empty for a folder.
std::string file_kind(const std::string& name) {
  std::error_code none;
  if (name.empty()) throw UserError("-o wants a name");
  if (name.ends_with('/') || fs::is_directory(name, none)) return "";
  std::string kind = fs::path(name).extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](char c) { return 'A' <= c && c <= 'Z' ? char(c + 32) : c; });
  return kind;
}

[[noreturn]] void refuse(const std::string& name, const std::string& valid) {
  throw UserError("-o " + name + ": a name ends in " + valid + ", or in / for a folder of PNG pictures");
}

/// A comment that long would not fit on ffmpeg's command line.
constexpr std::size_t longest_comment = 60'000;
constexpr const char* subtitles_extension = ".vtt";

} // namespace

VideoSettings video_settings(const Resolved& r, const std::string& study) {
  return {.width = r.output.size[0],
          .height = r.output.size[1],
          .fps = r.output.fps,
          .crf = r.output.crf,
          .animation_width = r.output.animation_width,
          .animation_fps = r.output.animation_fps,
          .title = r.title,
          .comment = study.size() < longest_comment ? study : ""};
}

std::vector<Cue> subtitles_of(const Resolved& r) {
  const double end = static_cast<double>(r.frames) / r.output.fps;
  std::vector<Cue> cues;
  for (const Timeline::Told& told : r.timeline.told()) {
    const double from = told.t / r.scale;
    if (from >= end) break;
    if (!cues.empty()) cues.back().to = from;
    cues.push_back({from, end, told.lines});
  }
  return cues;
}

std::vector<std::unique_ptr<Sink>> video_sinks(const std::vector<std::string>& names, const Resolved& r,
                                               const std::string& study) {
  std::vector<std::unique_ptr<Sink>> sinks;
  const auto once = [&](const fs::path& file) { // several videos of one name share what stands beside them
    return std::none_of(sinks.begin(), sinks.end(), [&](const auto& s) { return s->path() == file; });
  };
  const auto subtitles = [&](const fs::path& file) {
    if (once(file)) sinks.push_back(text_file(file, to_vtt(subtitles_of(r))));
  };
  for (const std::string& name : names) {
    const std::string kind = file_kind(name);
    const VideoFormat* format = find_video_format(kind);
    if (kind.empty()) {
      sinks.push_back(png_sequence(name));
    } else if (kind == subtitles_extension) {
      subtitles(name);
    } else if (format) {
      sinks.push_back(video_file(*format, name, video_settings(r, study)));
      const fs::path poster = beside(name, ".poster.png");
      if (r.output.poster >= 0 && once(poster)) sinks.push_back(poster_file(poster, r.output.poster));
      if (r.output.subtitles) subtitles(beside(name, subtitles_extension));
    } else {
      refuse(name, video_extensions(", ") + " or " + subtitles_extension);
    }
  }
  return sinks;
}

std::vector<std::unique_ptr<Sink>> still_sinks(const std::vector<std::string>& names, const Resolved& r,
                                               std::size_t pictures) {
  std::vector<std::unique_ptr<Sink>> sinks;
  for (const std::string& name : names) {
    const std::string kind = file_kind(name);
    if (kind.empty()) {
      const auto by_time = [study = r.name](const Provenance& p) {
        return study + "_" + to_toml(Value(p.time)) + "s.png";
      };
      sinks.push_back(png_files(name, by_time, name));
    } else if (kind == ".png" && pictures == 1) {
      const auto fixed = [file = fs::path(name).filename().string()](const Provenance&) { return file; };
      sinks.push_back(png_files(fs::path(name).parent_path(), fixed, name));
    } else {
      refuse(name, ".png for a single time");
    }
  }
  return sinks;
}

} // namespace flipbook::app
