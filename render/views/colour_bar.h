// SPDX-License-Identifier: MIT
// The key to the colours: quantity, unit and round numbers.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/colour_by.h"

namespace flipbook::render {

[[nodiscard]] std::string colour_bar_label(const ColourScale& scale);
void draw_colour_bar(gui::Ink& ink, const Rect& label, const Rect& bar, const ColourScale& scale,
                     const Palette& palette);

} // namespace flipbook::render
