// SPDX-License-Identifier: MIT
#include "app/figures/sketch.h"

#include "render/chart/panel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app {

using render::ChartPoint;

void draw_arrow(render::Pen& pen, ChartPoint from, ChartPoint to, render::Colour colour, double width) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 0.5) return;
  const double head = std::min(5.2 * width, 0.6 * length), half = 0.38 * head, ux = dx / length, uy = dy / length;
  const ChartPoint neck{to.x - 0.85 * head * ux, to.y - 0.85 * head * uy};
  pen.line(from, neck, colour, width);
  const std::array<ChartPoint, 3> tip{{to,
                                       {to.x - head * ux + half * uy, to.y - head * uy - half * ux},
                                       {to.x - head * ux - half * uy, to.y - head * uy + half * ux}}};
  pen.fill(tip, colour);
}

double draw_panels(const FigureArea& area, const std::vector<render::ChartPanel>& panels, double height) {
  constexpr double gap = 22;
  const auto count = static_cast<double>(panels.size());
  const double each = area.narrow() ? area.width : (area.width - gap * (count - 1)) / count;
  double x = area.x, y = area.y, heading = 0;
  if (!area.narrow())
    for (const render::ChartPanel& panel : panels) heading = std::max(heading, panel_heading(area.pen, panel, each));
  for (const render::ChartPanel& panel : panels) {
    draw_panel(area.pen, panel, rect(x, y, each, height), heading);
    if (area.narrow())
      y += height + 8;
    else
      x += each + gap;
  }
  return area.narrow() ? y - 8 : y + height;
}

double draw_lines(render::Pen& pen, double x, double y, double width, const std::string& text, double size,
                  render::Colour colour, render::Weight weight) {
  for (const std::string& line : pen.wrapped(text, size, width, weight)) {
    pen.text({x, y + size}, line, size, colour, weight);
    y += 1.34 * size;
  }
  return y;
}

double draw_legend(const FigureArea& area, const std::vector<Sign>& signs) {
  constexpr double behind_sign = 5, between = 16, row = 15;
  double x = area.x, y = area.y;
  for (const Sign& s : signs) {
    const double wide = s.width + behind_sign + area.pen.width(s.text, small_text);
    if (x > area.x && x + wide > area.right()) x = area.x, y += row;
    s.draw({x + s.width / 2, y + 6.5});
    area.pen.text({x + s.width + behind_sign, y + 10.3}, s.text, small_text, light().text);
    x += wide + between;
  }
  return y + row;
}

FigureTable chart_table(const std::vector<render::ChartPanel>& panels) {
  FigureTable table{.part = "", .columns = {"panel", "series", "x", "y", "lo", "hi"}};
  for (const render::ChartPanel& panel : panels)
    for (const render::ChartSeries& s : panel.series)
      for (std::size_t i = 0; i < s.x.size() && i < s.y.size(); ++i) {
        const double y = s.y[i];
        table.add(render::plain_text(panel.title), render::plain_text(s.label), s.x[i], y,
                  i < s.lo.size() ? s.lo[i] : y, i < s.hi.size() ? s.hi[i] : y);
      }
  return table;
}

} // namespace flipbook::app
