// SPDX-License-Identifier: MIT
// Arrows of the grid's velocity in a 2D pane, in the middle of cells or where the grid holds it, and their key.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

/// The speed that the arrow in the key stands for, the same in all panes; 0: nothing moves.
/// It follows the bulk of the particles; what is faster has a longer arrow, up to a point.
[[nodiscard]] double arrow_speed(const Frame& frame);
/// Velocity of the face lattices "u" and "v" in cells with liquid or beside them, thinned out until arrows are apart.
/// On faces each arrow is one component; nodes hold both. False: the lattices were not published.
bool draw_arrows(gui::Ink& ink, const PaneView& pane, const Palette& palette, double full_speed, ArrowsAt at);
/// An arrow and the speed it stands for, at the left of a line of text; returns the width.
float draw_arrow_key(gui::Ink& ink, const Rect& line, const Palette& palette, double full_speed);

} // namespace flipbook::render
