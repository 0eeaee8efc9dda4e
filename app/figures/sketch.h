// SPDX-License-Identifier: MIT
// What several figures draw beside charts: arrows, lattices, lettered panels, colour bars.
#pragma once

#include "app/figures/figure.h"
#include "render/chart/chart.h"
#include "render/theme.h"

#include <string>
#include <vector>

namespace flipbook::app {

[[nodiscard]] inline const render::Palette& light() {
  return render::palette(render::Theme::light);
}

/// A rectangle from doubles.
[[nodiscard]] inline render::Rect rect(double x, double y, double w, double h) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(w), static_cast<float>(h)};
}

/// Text sizes: of a panel's title, usual, small; the distance of lines of usual text.
inline constexpr double title_text = 13, usual_text = 12, small_text = 10.5, line_step = 16;

/// A shaft and a head in proportion, none where it is too short to be seen.
void draw_arrow(render::Pen& pen, render::ChartPoint from, render::ChartPoint to, render::Colour colour, double width);

/// Charts side by side, or one below the other where it is narrow; `height` of each. Returns where they end.
double draw_panels(const FigureArea& area, const std::vector<render::ChartPanel>& panels, double height);

/// Lines of text from y on; returns where they end.
double draw_lines(render::Pen& pen, double x, double y, double width, const std::string& text, double size,
                  render::Colour colour, render::Weight weight = render::Weight::regular);

/// An entry of a legend: a sign, drawn around the given point, and what it means.
struct Sign {
  std::string text;
  std::function<void(render::ChartPoint)> draw;
  double width = 10; ///< of the sign
};

/// Entries in rows of at most the area's width; returns where they end.
double draw_legend(const FigureArea& area, const std::vector<Sign>& signs);

/// The points of charts as a table: panel, series, x, y, lo, hi.
[[nodiscard]] FigureTable chart_table(const std::vector<render::ChartPanel>& panels);

} // namespace flipbook::app
