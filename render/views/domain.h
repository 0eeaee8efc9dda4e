// SPDX-License-Identifier: MIT
// What surrounds the particles of a 2D pane: the lattice and the walls.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

/// Lines between cells, thinned out by powers of two until they are apart.
void draw_grid(gui::Ink& ink, const PaneView& pane, const Palette& palette);
/// Solid lines on walls, dashes where the domain repeats itself.
void draw_walls(gui::Ink& ink, const PaneView& pane, const Palette& palette);

} // namespace flipbook::render
