// SPDX-License-Identifier: MIT
// How a series of a chart looks: its colour, the shape of its points, its line.
#pragma once

#include "render/chart/chart.h"
#include "render/chart/pen.h"

namespace flipbook::render {

[[nodiscard]] Colour colour_of(const ChartSeries& series);

/// The series on the page, x and y already in points; unfit places (not finite) break a line.
void draw_series(Pen& pen, const ChartSeries& series, std::span<const ChartPoint> points,
                 std::span<const ChartPoint> lo, std::span<const ChartPoint> hi);

/// A short piece of it for a legend, from `at` to the right.
void draw_sample(Pen& pen, const ChartSeries& series, ChartPoint at, double length);

} // namespace flipbook::render
