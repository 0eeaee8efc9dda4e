// SPDX-License-Identifier: MIT
// What a name given with -o means: "film.mp4" a video, "film.vtt" its subtitles, a folder PNG pictures, "picture.png"
// one still.
#pragma once

#include "app/encode/sink.h"
#include "app/encode/subtitles.h"
#include "app/encode/video.h"
#include "app/study/resolve.h"

#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

/// How a study's videos are encoded; `study` is its text.
[[nodiscard]] VideoSettings video_settings(const Resolved& r, const std::string& study);

/// What the timeline says, each until the next: its times are those of the video.
[[nodiscard]] std::vector<Cue> subtitles_of(const Resolved& r);

/// With a video its poster and subtitles where the study asks for them. Throws UserError for a name that says neither,
/// MachineError for what cannot be written.
[[nodiscard]] std::vector<std::unique_ptr<Sink>> video_sinks(const std::vector<std::string>& names, const Resolved& r,
                                                             const std::string& study);

/// Pictures named after the study and their time; a name ending in .png for a single one.
[[nodiscard]] std::vector<std::unique_ptr<Sink>> still_sinks(const std::vector<std::string>& names, const Resolved& r,
                                                             std::size_t pictures);

} // namespace flipbook::app
