// SPDX-License-Identifier: MIT
#include "render/chart/chart.h"

#include "render/chart/panel.h"
#include "render/chart/pen.h"
#include "render/font_file.h"
#include "render/theme.h"
#include "sim/frame/errors.h"

namespace flipbook::render {

namespace {

constexpr double page_width = 960, page_height = 540, scale = 2, margin = 32, gap = 36;

} // namespace

Image draw_chart(const Chart& chart) {
  const Palette& light = palette(Theme::light);
  Pen pen(page_width, page_height, scale, light.page);
  const double width = page_width - 2 * margin;
  double y = margin;
  for (const std::string& line : pen.wrapped(chart.title, 20, width, Weight::bold)) {
    pen.text({margin, y + 15}, line, 20, light.text, Weight::bold);
    y += 26;
  }
  const std::vector<std::string> caption = pen.wrapped(chart.caption, 10.5, width);
  double below = page_height - 20 - 14 * static_cast<double>(caption.size());
  const double height = below - y - 22;
  const auto count = static_cast<double>(chart.panels.size());
  const double each = (width - gap * (count - 1)) / count;
  double x = margin;
  for (const ChartPanel& panel : chart.panels) {
    draw_panel(
        pen, panel,
        {static_cast<float>(x), static_cast<float>(y + 10), static_cast<float>(each), static_cast<float>(height)});
    x += each + gap;
  }
  for (const std::string& line : caption) pen.text({margin, below += 14}, line, 10.5, light.muted);
  return pen.image();
}

void check_chart_fonts() {
  for (const char* file : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"})
    if (find_font(file).empty()) throw MachineError(no_font(file) + ": a chart cannot be drawn");
}

} // namespace flipbook::render
