// SPDX-License-Identifier: MIT
// Title and study inside animations, which ffmpeg leaves out: GIF has comments, WebP has XMP (the "description" of
// Dublin Core).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace flipbook::app {

/// The file's bytes with the text in a comment in front of the first picture; unchanged where they are no GIF.
[[nodiscard]] std::string with_gif_comment(std::string_view gif, std::string_view text);
/// The file's bytes with the text as a last chunk; unchanged where they are no animated WebP.
[[nodiscard]] std::string with_webp_description(std::string_view webp, std::string_view text);

} // namespace flipbook::app
