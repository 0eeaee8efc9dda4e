// SPDX-License-Identifier: MIT
// Where everything goes. Panes are as large as the picture allows: the number of columns, and whether the plots lie
// below or beside the panes, follow from the shape of the domain.
//
//   title                          colour bar   time
//   +--------+ +--------+   +---------+
//   | pane   | | pane   |   | panel   |
//   +--------+ +--------+   |         |
//   (ledger)   (ledger)     |         |   or each beside its pane
//   legend                  |         |
//   +----+ +----+ +----+    |         |
//   |plot| |plot| |plot|    |         |
//   +----+ +----+ +----+    +---------+
//   warnings and notes
//
// One pane may be large: it gets what the others leave, who stand beside or below it and are as small as can be read.
#pragma once

#include "render/shapes.h"

#include <optional>
#include <vector>

namespace flipbook::render {

/// A form in which the tables of the ledger may be shown.
struct TableSize {
  float width = 0, height = 0; ///< pixels of one table
  float worth = 1; ///< panes may shrink to this share of what a form of worth 1 leaves them, and it is chosen instead
};

/// What has to be placed.
struct LayoutRequest {
  int width = 1280, height = 720;
  float scale = 1;                            ///< pixels of a point
  std::size_t panes = 1;                      ///< boxes that hold panes; at least 1
  std::optional<std::size_t> large;           ///< the one that is larger than the others
  std::optional<std::size_t> bar;             ///< the one that has a colour bar of its own, in the line below it
  double domain_width = 1, domain_height = 1; ///< the shape every pane must be able to hold
  bool captions = true, panel = true;
  bool label = false; ///< a line of its own below the title
  std::size_t plots = 4;
  double plot_height = 0.24; ///< share of the picture; 0: no plots
  std::vector<float> legend; ///< width of each entry, pixels
  std::size_t references =
      0; ///< how many of them, the last ones, are others' curves: if need be on a line of their own
  std::size_t footer_lines = 0;
  std::vector<TableSize> tables;    ///< one form of them is placed if there is room; empty: no tables
  std::size_t tables_of_large = 1;  ///< a split pane has two; beside a large one the small ones have none
  float colour_label = 0, time = 0; ///< widths of the texts in the header, pixels; no label: no colour bar
};

struct PaneBox {
  Rect title, frame, caption;
  Rect table, second_table; ///< empty where none is shown
  float padding = 0;        ///< between the frame and the domain, pixels; less in small panes
};

struct Layout {
  Rect title, colour_label, colour_bar, time; ///< the header
  Rect label;                                 ///< below the title; empty where there is none
  std::vector<PaneBox> panes;
  std::vector<Rect> legend, plots;
  Rect panel, footer;
  int tables = -1; ///< which of the forms is shown; -1: none
};

/// Pixels of a point for a picture of this size: 1 at 1280x720, never so small that text cannot be read.
[[nodiscard]] float point_size(int width, int height);
[[nodiscard]] Layout arrange(const LayoutRequest& request);

} // namespace flipbook::render
