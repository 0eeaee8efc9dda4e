// SPDX-License-Identifier: MIT
// One panel of a chart: title, legend, axes, series and the names beside their ends.
#pragma once

#include "render/chart/chart.h"
#include "render/chart/pen.h"

namespace flipbook::render {

void draw_panel(Pen& pen, const ChartPanel& panel, const Rect& box);

} // namespace flipbook::render
