// SPDX-License-Identifier: MIT
// The ffmpeg program as a sink: raw pictures go in, a file comes out. It is started when the sink is made, so that what
// cannot work is refused before anything is simulated.
#pragma once

#include "app/encode/process.h"
#include "app/encode/staging.h"
#include "app/encode/video.h"

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

/// Throws MachineError that says where it was looked for and what works without it.
[[nodiscard]] std::filesystem::path find_ffmpeg();

using Words = std::vector<std::string>;
[[nodiscard]] Words joined(std::initializer_list<Words> parts);

/// From YUV of any kind: players take untagged HD video for BT.709, ffmpeg converts to BT.601 unless told, so that it
/// is said in both places. For what has yuv420p.
[[nodiscard]] Words bt709();
/// Title and comment, and nothing that differs from run to run.
[[nodiscard]] Words metadata(const VideoSettings& s);
/// Title and study, for what ffmpeg writes neither into.
[[nodiscard]] std::string told(const VideoSettings& s);
/// The filter that makes it as small as animations are: "scale=640:360:flags=lanczos".
[[nodiscard]] std::string animation_scale(const VideoSettings& s);
/// And as slow: "fps=12.5,scale=...".
[[nodiscard]] std::string animation_filters(const VideoSettings& s);

class FfmpegFile : public Sink {
public:
  /// `encoding`: the arguments between the input and the name of the file. `name`: of that file, which may be one that
  /// finish() takes away again, or a pattern for several; empty: the final one.
  FfmpegFile(const std::filesystem::path& file, const VideoSettings& s, const Words& encoding,
             const std::string& name = "");

  void write(const Picture& picture) override;
  void finish() override;
  void commit() override { staging_.commit(); }
  [[nodiscard]] std::filesystem::path path() const override { return path_; }
  [[nodiscard]] bool computes() const override { return false; } // ffmpeg has its own, fixed number of threads

protected:
  /// Rewrites the finished file: with the text inside, for example.
  void rewrite(const std::function<std::string(std::string_view bytes)>& change) const;
  /// Another run of it, without input from here.
  void run(const Words& arguments) const;
  /// A file under construction: `name`, or what becomes the final one.
  [[nodiscard]] std::string staged(const std::string& name = "") const;

private:
  void check(const std::string& how) const;

  std::filesystem::path path_;
  Staging staging_;
  Process encoder_;
  int width_, height_; ///< that every picture must have
};

} // namespace flipbook::app
