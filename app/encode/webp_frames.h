// SPDX-License-Identifier: MIT
// Pictures as still WebP files of one folder: prefix0000.webp, prefix0001.webp, ... in the order in which they come.
#pragma once

#include "app/encode/video.h"

#include <filesystem>
#include <memory>
#include <string>

namespace flipbook::app {

/// `quality`: 0 to 100, as of JPEG. Throws MachineError when there is no ffmpeg.
[[nodiscard]] std::unique_ptr<Sink> webp_frames(const std::filesystem::path& folder, const std::string& prefix,
                                                const VideoSettings& settings, int quality);

} // namespace flipbook::app
