// SPDX-License-Identifier: MIT
// Curves over time, one for each pane in the colour of its frame.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/theme.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::render {

/// A curve that view.plots can name.
struct PlotName {
  std::string_view name;         ///< of the history's column
  std::string_view label, brief; ///< above the plot, and where there is little room
};
/// All of them. A column of any other name can be plotted too, under its own name.
[[nodiscard]] std::span<const PlotName> plot_names();
/// Stands for what each stage took of the kinetic energy: a plot for each stage of the run.
inline constexpr std::string_view lost_by_stage = "lost";

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
