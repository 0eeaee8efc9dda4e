// SPDX-License-Identifier: MIT
// What the solver takes the cells of a 2D pane for: tints of liquid and air under the particles, of solid cells over
// the solids, the borders between kinds over all of it, and the key in the footer.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

/// Has the simulation said what its cells are?
[[nodiscard]] bool has_cell_types(const Snapshot& s);
void draw_cell_tints(gui::Ink& ink, const PaneView& pane, const Palette& palette);
void draw_cell_borders(gui::Ink& ink, const PaneView& pane, const Palette& palette);
/// A square of each tint with its name, at the left of a line of text; returns the width.
float draw_cell_key(gui::Ink& ink, const Rect& line, const Palette& palette);

} // namespace flipbook::render
