// SPDX-License-Identifier: MIT
// Where the fonts are: DejaVu, from a file, so that no look-up of the system decides what a picture looks like.
#pragma once

#include <string>

namespace flipbook::render {

/// The path of "DejaVuSans.ttf": in the folder FLIPBOOK_FONTS, else where distributions keep it; empty if nowhere.
[[nodiscard]] std::string find_font(const char* file);

/// What to say where it is empty.
inline constexpr const char* no_font_hint =
    "no DejaVu fonts found (package fonts-dejavu-core, or FLIPBOOK_FONTS=folder)";

} // namespace flipbook::render
