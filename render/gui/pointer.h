// SPDX-License-Identifier: MIT
// The arrow that the scripted hand moves.
#pragma once

#include "render/gui/ink.h"

namespace flipbook::render::gui {

/// Where the pointer is between its rest below the widget (travel = 0, where nobody sees it) and `target` (travel = 1).
/// `point` is in pixels.
[[nodiscard]] Point pointer_at(Point target, double travel, float point);

/// Draws the arrow with its tip at `tip`; it appears as it travels, and only near its widget.
void draw_pointer(Ink& ink, Point tip, double travel, bool pressed);

} // namespace flipbook::render::gui
