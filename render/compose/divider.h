// SPDX-License-Identifier: MIT
// Two panes in one frame: a line parts them, with a handle to move it by.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"

#include <array>
#include <cstddef>

namespace flipbook::render {

struct Split {
  std::array<std::size_t, 2> panes; ///< left and right
  Rect frame;
  float from = 0, to = 0; ///< where the divider stands at 0 and at 1: the sides of what is seen of the domain, pixels
  float at = 0;           ///< and where it stands, between two pixels

  /// What is seen of the left (0) or right (1) pane: together the frame.
  [[nodiscard]] Rect side(std::size_t i) const;
  /// The position, 0 to 1, that brings it to this pixel.
  [[nodiscard]] double position(float x) const;
  /// Is the pixel near enough to take hold of it? `reach` in pixels.
  [[nodiscard]] bool near(gui::Point pixel, float reach) const;
};

/// `domain`: the rectangle of both panes' domains.
[[nodiscard]] Split split_at(double position, const std::array<std::size_t, 2>& panes, const Rect& frame,
                             const Rect& domain);

/// The frame in the colour of each pane on its side, the divider and its handle.
void draw_divider(gui::Ink& ink, const Split& split, const std::array<Colour, 2>& colours, const Palette& palette);

} // namespace flipbook::render
