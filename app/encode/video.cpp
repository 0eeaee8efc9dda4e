// SPDX-License-Identifier: MIT
#include "app/encode/video.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <array>

namespace flipbook::app {

namespace {

constexpr std::array<VideoFormat, 4> formats{{
    {".mp4", "A video (H.264): plays everywhere", true, mp4_file},
    {".webm", "A video (AV1), a third smaller; Apple devices before 2023 do not play it", true, webm_file},
    {".gif", "An animation of 256 colours for slides: at most output.animation_width wide", false, gif_file},
    {".webp", "An animation for pages, a fraction of a GIF: at most output.animation_width wide", false, webp_file},
}};

} // namespace

std::span<const VideoFormat> video_formats() {
  return formats;
}

std::string video_extensions(std::string_view between_last) {
  std::string all;
  for (const VideoFormat& f : formats) {
    if (!all.empty()) all += &f == &formats.back() ? between_last : ", ";
    all += f.extension;
  }
  return all;
}

const VideoFormat* find_video_format(std::string_view extension) {
  const auto* at = std::find_if(formats.begin(), formats.end(), [&](auto& f) { return f.extension == extension; });
  return at == formats.end() ? nullptr : at;
}

std::unique_ptr<Sink> video_file(const VideoFormat& format, const std::filesystem::path& file,
                                 const VideoSettings& settings) {
  if (format.even && (settings.width % 2 != 0 || settings.height % 2 != 0))
    throw UserError("a " + std::string(format.extension) + " video needs an even width and height (yuv420p), not " +
                    std::to_string(settings.width) + "x" + std::to_string(settings.height));
  return format.open(file, settings);
}

std::unique_ptr<Sink> video_file(const std::filesystem::path& file, const VideoSettings& settings) {
  return video_file(formats.front(), file, settings);
}

} // namespace flipbook::app
