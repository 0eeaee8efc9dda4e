// SPDX-License-Identifier: MIT
// Where and with what the exhibits of a gallery are made.
#pragma once

#include "app/session/session.h"
#include "sim/core/parallel.h"

#include <filesystem>
#include <string>

namespace flipbook::app::gallery {

inline constexpr const char* media_folder = "media"; ///< below that of the gallery

struct Workshop {
  std::filesystem::path folder; ///< of the gallery
  SessionOptions session;       ///< threads, what draws
  bool ffmpeg = true;           ///< is there one? Without it pictures stand for videos

  /// "media/dam_break.mp4": as the page names it.
  [[nodiscard]] static std::string media(const std::string& file) { return std::string(media_folder) + "/" + file; }
  [[nodiscard]] std::filesystem::path path(const std::string& file) const { return folder / file; }
  /// Throws Interrupted where a person wants it to end: what draws by itself asks between two pictures.
  static void go_on();
  /// Tells what is done, unless it shall be quiet.
  void say(const std::string& what) const;
};

} // namespace flipbook::app::gallery
