// SPDX-License-Identifier: MIT
// What goes beside a video: its poster, the picture that stands there until it plays, and its subtitles.
#pragma once

#include "app/encode/sink.h"

#include <filesystem>
#include <memory>
#include <string>

namespace flipbook::app {

/// "film.poster.png" of "film.mp4".
[[nodiscard]] std::filesystem::path beside(const std::filesystem::path& video, const std::string& ending);

/// Writes the picture nearest to `time` (simulated seconds), the earlier of two, as a PNG with its provenance.
[[nodiscard]] std::unique_ptr<Sink> poster_file(const std::filesystem::path& file, double time);

/// Writes a text that is known before the first picture comes.
[[nodiscard]] std::unique_ptr<Sink> text_file(const std::filesystem::path& file, const std::string& text);

} // namespace flipbook::app
