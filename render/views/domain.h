// SPDX-License-Identifier: MIT
// What surrounds the particles of a 2D pane: the lattice, the walls, and arrows of the face velocities.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

/// Lines between cells, thinned out by powers of two until they are apart.
void draw_grid(gui::Ink& ink, const PaneView& pane, const Palette& palette);
/// Solid lines on walls, dashes where the domain repeats itself.
void draw_walls(gui::Ink& ink, const PaneView& pane, const Palette& palette);

/// The speed that the arrow in the key stands for, the same in all panes; 0: nothing moves.
/// It follows the bulk of the particles; what is faster has a longer arrow, up to a point.
[[nodiscard]] double arrow_speed(const Frame& frame);
/// Velocity in cells with particles, from the face lattices "u" and "v". False: they were not published.
bool draw_arrows(gui::Ink& ink, const PaneView& pane, const Palette& palette, double full_speed);
/// An arrow and the speed it stands for, at the left of a line of text; returns the width.
float draw_arrow_key(gui::Ink& ink, const Rect& line, const Palette& palette, double full_speed);

} // namespace flipbook::render
