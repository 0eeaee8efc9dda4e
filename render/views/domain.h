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

/// The speed that an arrow of full length stands for, the same in all panes; 0 if nothing moves.
[[nodiscard]] double arrow_speed(const Frame& frame);
/// Velocity where there are particles, interpolated from the face lattices "u" and "v". False: they were not published.
bool draw_arrows(gui::Ink& ink, const PaneView& pane, const Palette& palette, double full_speed);

} // namespace flipbook::render
