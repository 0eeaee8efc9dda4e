// SPDX-License-Identifier: MIT
// Where the fonts are: DejaVu, from a file, so that no look-up of the system decides what a picture looks like.
#pragma once

#include <string>

namespace flipbook::render {

/// The path of "DejaVuSans.ttf": in the folder FLIPBOOK_FONTS if that is set, and nowhere else then; otherwise where
/// distributions keep it. Empty if nowhere.
[[nodiscard]] std::string find_font(const char* file);

/// What to say where it is empty: where it was looked for, and how to get it.
[[nodiscard]] std::string no_font(const char* file);

} // namespace flipbook::render
