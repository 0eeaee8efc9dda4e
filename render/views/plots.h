// SPDX-License-Identifier: MIT
// Curves over time, one for each pane in the colour of its frame.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/plot_names.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::render {

/// One quantity in all the panes that recorded it.
struct Plot {
  std::string name, unit;
  struct Curve {
    std::size_t pane;
    const std::vector<float>*t, *y;
  };
  std::vector<Curve> curves;
};

/// The plots that the settings ask for and that exist.
[[nodiscard]] std::vector<Plot> plots_of(const Frame& frame, const ViewSettings& view);
/// Draws each plot in its box. All keep the same room for their labels, so that axes one below the other line up.
void draw_plots(gui::Ink& ink, std::span<const Rect> boxes, std::span<const Plot> plots, const Frame& frame,
                const Palette& palette);

/// How the curve of a pane is drawn; the legend shows the same. From the seventh pane on curves are dashed, so that
/// they differ in more than colour.
void draw_stroke(gui::Ink& ink, std::span<const gui::Point> points, std::size_t pane, const Palette& palette);

} // namespace flipbook::render
