// SPDX-License-Identifier: MIT
// What a name given with -o means: "film.mp4" a video, a folder PNG pictures, "picture.png" one still.
#pragma once

#include "app/encode/sink.h"
#include "app/study/resolve.h"

#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

/// Throws UserError for a name that says neither, MachineError for what cannot be written.
[[nodiscard]] std::vector<std::unique_ptr<Sink>> video_sinks(const std::vector<std::string>& names, const Resolved& r,
                                                             const std::string& study);

/// Pictures named after the study and their time; a name ending in .png for a single one.
[[nodiscard]] std::vector<std::unique_ptr<Sink>> still_sinks(const std::vector<std::string>& names, const Resolved& r,
                                                             std::size_t pictures);

} // namespace flipbook::app
