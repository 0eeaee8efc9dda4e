// SPDX-License-Identifier: MIT
// Where some particles of a 2D pane have been: lines that fade with their age, and a dot where the particle is.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/pane_view.h"

#include <vector>

namespace flipbook::render {

/// The way of a particle, from now back.
struct Way {
  std::vector<gui::Point> at;
  std::vector<float> age; ///< of each point, as a share of `seconds`
};

/// Ways of the last `seconds`, cut where a particle crosses a periodic side.
[[nodiscard]] std::vector<Way> ways(const PaneView& pane, double seconds);

void draw_trails(gui::Ink& ink, const PaneView& pane, double seconds, const Palette& palette);

} // namespace flipbook::render
