// SPDX-License-Identifier: MIT
// A contact sheet: panes in rows and columns with their names at the margins, on one colour scale, and below each pane
// one quantity over time as a small curve. All curves share their axes; a dot is the present, a number its value.
#pragma once

#include "render/compose/layout.h"
#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/theme.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace flipbook::render {

/// The quantity in all panes.
struct Sparklines {
  std::string label;                           ///< what it is, with the ends of its axis
  double lo = 0, hi = 1;                       ///< of the axis
  double factor = 1;                           ///< value * factor is what the numbers say
  std::vector<const History::Column*> columns; ///< of each pane; null: it does not record that
};

/// Nothing where the view asks for none or no pane records it.
[[nodiscard]] std::optional<Sparklines> sparklines_of(const Frame& frame, const ViewSettings& view);

class ContactSheet {
public:
  ContactSheet(const Frame& frame, const ViewSettings& view, const gui::Fonts& fonts);

  /// Places the panes into the body of a layout that has its header, its footer and its panel. `domain_width` and
  /// `domain_height`: the shape that every pane must be able to hold.
  void arrange(const LayoutRequest& request, Layout& layout);
  /// Names and curves. The panes are drawn by the page.
  void draw(gui::Ink& ink, const Palette& palette) const;

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] const std::optional<Sparklines>& sparklines() const { return sparklines_; }
  /// Do the margins name the panes, so that these need no titles?
  [[nodiscard]] bool named() const { return !frame_.sheet.columns.empty() || !frame_.sheet.rows.empty(); }

private:
  /// Pixels: of a pane's frame, of its curve below it or beside it, and of its title.
  struct Grid {
    float frame_w = 0, frame_h = 0, padding = 0, curve_w = 0, curve_h = 0, title = 0;
    bool beside = false;
    [[nodiscard]] float width() const { return beside ? frame_w + curve_w : frame_w; }
    [[nodiscard]] float height() const { return title + frame_h + (beside ? 0 : curve_h); }
  };
  [[nodiscard]] std::size_t rows() const { return (frame_.panes.size() + columns_ - 1) / columns_; }
  [[nodiscard]] Rect body_of(const LayoutRequest& request, const Layout& layout) const;
  [[nodiscard]] Grid grid_in(const Rect& area, const LayoutRequest& request, bool beside) const;
  [[nodiscard]] Rect curve_of(const Grid& grid, const Rect& frame) const;
  void place_names(const Rect& area, float pitch, const Layout& layout);
  [[nodiscard]] Rect curve_area(std::size_t pane) const;
  void draw_curve(gui::Ink& ink, std::size_t pane, const Palette& palette) const;
  [[nodiscard]] float pt(float points) const;

  const Frame& frame_;
  const gui::Fonts& fonts_;
  std::size_t columns_ = 1;
  std::optional<Sparklines> sparklines_;
  float gutter_ = 0, number_ = 0; ///< widths of the row names and of a curve's number, pixels
  bool beside_ = false;           ///< do the curves stand beside their panes?
  std::vector<Rect> row_names_, column_names_, curves_;
};

} // namespace flipbook::render
