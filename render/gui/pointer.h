// SPDX-License-Identifier: MIT
// The arrow that the scripted hand moves.
#pragma once

#include "render/gui/ink.h"

namespace flipbook::render::gui {

/// Where the pointer is between its rest below the picture (travel = 0) and `target` (travel = 1).
[[nodiscard]] Point pointer_at(Point target, double travel, int width, int height);

/// Draws the arrow with its tip at `tip`.
void draw_pointer(Ink& ink, Point tip, bool pressed);

} // namespace flipbook::render::gui
