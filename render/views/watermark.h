// SPDX-License-Identifier: MIT
// What keeps a picture from being taken for a normal one: a banner along the upper edge of a pane, and what it says
// before its colon large, faint and slanted across all of it, which no cropping removes.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"

#include <string>

namespace flipbook::render {

void draw_watermark(gui::Ink& ink, const Rect& pane, const std::string& text, const Palette& palette);

} // namespace flipbook::render
