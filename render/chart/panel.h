// SPDX-License-Identifier: MIT
// One panel of a chart: title, legend, axes, series and the names beside their ends.
#pragma once

#include "render/chart/chart.h"
#include "render/chart/pen.h"

namespace flipbook::render {

/// What stands above the plot, title and legend, takes this height; at least `heading`, so that panels side by side
/// begin at one height.
[[nodiscard]] double panel_heading(const Pen& pen, const ChartPanel& panel, double width);
void draw_panel(Pen& pen, const ChartPanel& panel, const Rect& box, double heading = 0);

} // namespace flipbook::render
