// SPDX-License-Identifier: MIT
// The domain of a 3D pane. What lies behind everything in it (floor, far walls) is drawn before the particles, and what
// lies before it (the near edges, thinner) after them: a box is convex, so that no depth test is needed, and lines stay
// as crisp as in 2D. Edges of faces that repeat themselves are dashed.
#pragma once

#include "render/theme.h"
#include "render/views/pane_view.h"

namespace flipbook::render {

/// One of the six faces of the domain.
struct Face {
  std::size_t axis;
  bool upper;
};
/// Does the viewer see it from within the domain?
[[nodiscard]] bool is_far(const PaneView& pane, Face face);
[[nodiscard]] Face floor_of(const Snapshot& s);
/// The four corners in order around it, in the world.
[[nodiscard]] std::array<std::array<double, 3>, 4> corners_of(const Snapshot& s, Face face);

/// The floor, with the lines between cells if `grid`; the far walls if `walls`.
void draw_tank_behind(gui::Ink& ink, const PaneView& pane, const Palette& palette, bool walls, bool grid);
void draw_tank_before(gui::Ink& ink, const PaneView& pane, const Palette& palette);

} // namespace flipbook::render
