// SPDX-License-Identifier: MIT
// Pictures as still WebP files, a third of what PNG takes where particles are drawn.
#pragma once

#include "app/encode/video.h"

#include <filesystem>
#include <memory>
#include <string>

namespace flipbook::app {

/// From the scale of H.264 to that of WebP and JPEG: 18 is 75, 51 is 29.
[[nodiscard]] int picture_quality(int crf);

/// Files of one folder in the order in which the pictures come: prefix0000.webp, prefix0001.webp, ... Throws
/// MachineError when there is no ffmpeg.
[[nodiscard]] std::unique_ptr<Sink> webp_pictures(const std::filesystem::path& folder, const std::string& prefix,
                                                  const VideoSettings& settings);
/// One file, as wide as an animation. The first picture counts.
[[nodiscard]] std::unique_ptr<Sink> webp_picture(const std::filesystem::path& file, const VideoSettings& settings);

} // namespace flipbook::app
