// SPDX-License-Identifier: MIT
// Boxes of equal size in rows and columns. Each is a frame with a title above it, a line below it, and tables beside or
// below it where there is room for them.
#pragma once

#include "render/compose/layout.h"

#include <cmath>
#include <span>
#include <vector>

namespace flipbook::render {

/// What is alike of the boxes of a grid.
struct BoxKind {
  bool line = true;       ///< below each frame
  std::size_t tables = 1; ///< of each, where there are any
};

/// Rows and columns, and what they leave of the panes.
struct BoxGrid {
  std::size_t columns = 1, rows = 1;
  float magnification = 0; ///< pixels for each unit of the domain
  float padding = 0;
  int tables = -1;                     ///< which form of them; -1: none
  bool beside = false, in_row = false; ///< where they are: below the frame or beside it; two of them side by side
  float score = 0; ///< what is compared: magnification, by the worth of the tables and of rows without a hole
};

class BoxRules {
public:
  explicit BoxRules(const LayoutRequest& r) : r_(r) {}

  /// The grid of `count` boxes with the largest panes, with tables where these stay large enough to be looked at.
  [[nodiscard]] BoxGrid best(const Rect& area, std::size_t count, const BoxKind& kind) const;
  /// Places them from the top, with this share of the free width on their left, and returns the rectangle they use. A
  /// short last row begins at the left as any row of text.
  Rect place(const Rect& area, const BoxGrid& grid, const BoxKind& kind, float most_gap_x, float indent,
             std::span<PaneBox* const> boxes) const;

  /// Of a square as large as a pane, pixels.
  [[nodiscard]] float side_of(const BoxGrid& grid) const {
    return grid.magnification * static_cast<float>(std::sqrt(r_.domain_width * r_.domain_height));
  }
  [[nodiscard]] float pt(float points) const { return std::round(points * r_.scale); }

private:
  /// What the tables of a box take, all of them together.
  [[nodiscard]] TableSize taken(const BoxGrid& grid, const BoxKind& kind) const;
  [[nodiscard]] BoxGrid best(const Rect& area, std::size_t count, const BoxKind& kind, const BoxGrid& tables) const;
  void place_tables(PaneBox& box, const BoxGrid& grid, const BoxKind& kind, float widest, float bottom) const;
  [[nodiscard]] float spread(float spare, float gaps, float most) const;
  [[nodiscard]] float line(const BoxKind& kind) const;
  [[nodiscard]] float gap_to_table(const BoxKind& kind) const;

  const LayoutRequest& r_;
};

inline constexpr float box_gap = 14, widest_box_gap = 44; // points

} // namespace flipbook::render
