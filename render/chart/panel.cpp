// SPDX-License-Identifier: MIT
#include "render/chart/panel.h"

#include "render/chart/axis.h"
#include "render/chart/series.h"
#include "render/theme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipbook::render {

namespace {

constexpr double title_size = 14, text_size = 12, line_height = 17, sample_length = 22;

struct Extent {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  void cover(double value, bool positive) {
    if (!std::isfinite(value) || (positive && value <= 0)) return;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  [[nodiscard]] Extent or_unit() const { return lo <= hi ? *this : Extent{0.1, 1}; }
};

Extent extent(const ChartPanel& panel, const ChartAxis& axis, bool along_x) {
  Extent e;
  for (const ChartSeries& s : panel.series)
    for (const auto* values : along_x ? std::vector{&s.x} : std::vector{&s.y, &s.lo, &s.hi})
      for (const double v : *values) e.cover(v, axis.logarithmic);
  return e.or_unit();
}

/// A series that reaches the right edge is named there, others in the legend.
bool ends_at_edge(const ChartSeries& s, const AxisScale& x, const AxisScale& y) {
  using Style = ChartSeries::Style;
  if (s.x.empty() || s.named == ChartSeries::Named::legend || s.style == Style::points || s.style == Style::levels)
    return false;
  const double edge = x(x.hi()), near = 0.03 * (edge - x(x.lo()));
  return std::abs(x(s.x.back()) - edge) < near && y.shows(s.y.back());
}

struct Layout {
  const ChartPanel& panel;
  Rect plot;
  AxisScale x, y;
};

void draw_axes(Pen& pen, const Layout& l) {
  const Palette& light = palette(Theme::light);
  const auto left = static_cast<double>(l.plot.x), right = static_cast<double>(l.plot.right()),
             bottom = static_cast<double>(l.plot.bottom()), top = static_cast<double>(l.plot.y);
  for (const AxisScale::Tick& t : l.y.ticks()) {
    const double at = l.y(t.value);
    pen.line(std::array<ChartPoint, 2>{{{left, at}, {right, at}}}, light.grid, 0.8);
    pen.text({left - 7, at + 4.3}, t.text, text_size, light.muted, Weight::regular, Align::right);
  }
  for (const AxisScale::Tick& t : l.x.ticks()) {
    const double at = l.x(t.value);
    if (l.panel.x.names.empty()) pen.line(std::array<ChartPoint, 2>{{{at, top}, {at, bottom}}}, light.grid, 0.8);
    pen.text({at, bottom + 17}, t.text, text_size, light.muted, Weight::regular, Align::centre);
  }
  pen.line(std::array<ChartPoint, 2>{{{left, bottom}, {right, bottom}}}, light.accent, 1);
  pen.text({(left + right) / 2, bottom + 36}, l.panel.x.label, text_size, light.text, Weight::regular, Align::centre);
}

std::vector<ChartPoint> placed(const Layout& l, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<ChartPoint> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const bool drawable = !(l.panel.y.logarithmic && y[i] <= 0) && !(l.panel.x.logarithmic && x[i] <= 0);
    points.push_back({l.x(x[i]), drawable ? l.y(y[i]) : std::numeric_limits<double>::quiet_NaN()});
  }
  return points;
}

/// Measured series over exact ones.
void draw_all(Pen& pen, const Layout& l) {
  pen.clip({l.plot.x - 8, l.plot.y - 8, l.plot.w + 16, l.plot.h + 16});
  for (const bool exact : {true, false})
    for (const ChartSeries& s : l.panel.series)
      if (exact == (s.colour == ChartSeries::exact))
        draw_series(pen, s, placed(l, s.x, s.y), placed(l, s.x, s.lo), placed(l, s.x, s.hi));
  pen.release();
}

/// The names at the right edge, moved apart where their series end close together, each with a line to its end.
void draw_end_names(Pen& pen, const Layout& l, double left) {
  struct Name {
    const ChartSeries* series;
    double end, at;
  };
  std::vector<Name> names;
  for (const ChartSeries& s : l.panel.series)
    if (!s.label.empty() && ends_at_edge(s, l.x, l.y)) names.push_back({&s, l.y(s.y.back()), l.y(s.y.back())});
  std::stable_sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.end < b.end; });
  const auto top = static_cast<double>(l.plot.y), bottom = static_cast<double>(l.plot.bottom());
  for (int pass = 0; pass < 200; ++pass) // neighbours push each other apart
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i > 0 && names[i].at - names[i - 1].at < line_height) {
        const double middle = (names[i].at + names[i - 1].at) / 2;
        names[i - 1].at = middle - line_height / 2;
        names[i].at = middle + line_height / 2;
      }
      names[i].at = std::clamp(names[i].at, top + 4, bottom);
    }
  for (const Name& n : names) {
    const Colour colour = colour_of(*n.series);
    const auto right = static_cast<double>(l.plot.right());
    pen.line(std::array<ChartPoint, 3>{{{right + 7, n.end}, {left - 9, n.at}, {left - 4, n.at}}}, colour.alpha(0.55),
             1);
    pen.text({left, n.at + 4.3}, n.series->label, text_size, colour);
  }
}

/// Rows of samples with names, at most `width` wide. Returns how high they are; draws where `pen` is given.
double legend(const Pen& measure, Pen* pen, const std::vector<const ChartSeries*>& entries, ChartPoint at,
              double width) {
  if (entries.empty()) return 0;
  double x = at.x, y = at.y + 12;
  for (const ChartSeries* s : entries) {
    const double wide = sample_length + 7 + measure.width(s->label, text_size) + 18;
    if (x > at.x && x + wide - 18 > at.x + width) x = at.x, y += line_height + 2;
    if (pen) {
      draw_sample(*pen, *s, {x, y - 4}, sample_length);
      pen->text({x + sample_length + 7, y}, s->label, text_size, palette(Theme::light).text);
    }
    x += wide;
  }
  return y - at.y + 12;
}

double widest(const Pen& pen, const std::vector<std::string>& texts) {
  double width = 0;
  for (const std::string& t : texts) width = std::max(width, pen.width(t, text_size));
  return width;
}

/// The largest box inside with a metre as long along x as along y.
Rect with_equal_scales(const Rect& box, const AxisScale& x, const AxisScale& y) {
  Rect r = box;
  const auto wide = static_cast<float>(x.hi() - x.lo()), high = static_cast<float>(y.hi() - y.lo());
  if (box.w / wide < box.h / high)
    r.h = high * box.w / wide;
  else
    r.w = wide * box.h / high;
  return r;
}

} // namespace

double panel_heading(const Pen& pen, const ChartPanel& panel, double width) {
  const Extent ex = extent(panel, panel.x, true), ey = extent(panel, panel.y, false);
  const AxisScale x(panel.x, ex.lo, ex.hi, 0, 400), y(panel.y, ey.lo, ey.hi, 300, 0);
  std::vector<const ChartSeries*> entries;
  for (const ChartSeries& s : panel.series)
    if (!s.label.empty() && !ends_at_edge(s, x, y)) entries.push_back(&s);
  return 26 + legend(pen, nullptr, entries, {0, 0}, width);
}

void draw_panel(Pen& pen, const ChartPanel& panel, const Rect& box, double least_heading) {
  const Palette& light = palette(Theme::light);
  const Extent ex = extent(panel, panel.x, true), ey = extent(panel, panel.y, false);
  const AxisScale x(panel.x, ex.lo, ex.hi, 0, 400), y(panel.y, ey.lo, ey.hi, 300, 0);
  std::vector<std::string> numbers, names;
  std::vector<const ChartSeries*> in_legend;
  for (const AxisScale::Tick& t : y.ticks()) numbers.push_back(t.text);
  for (const ChartSeries& s : panel.series) {
    if (s.label.empty()) continue;
    if (ends_at_edge(s, x, y))
      names.push_back(s.label);
    else
      in_legend.push_back(&s);
  }
  const double left = static_cast<double>(box.x), top = static_cast<double>(box.y), width = static_cast<double>(box.w);
  pen.text({left, top + 14}, panel.title, title_size, light.text, Weight::bold);
  const double heading = std::max(least_heading, 26 + legend(pen, &pen, in_legend, {left, top + 26}, width));
  const double room_left = widest(pen, numbers) + 9, room_right = names.empty() ? 10 : widest(pen, names) + 28;
  Rect plot{static_cast<float>(left + room_left), static_cast<float>(top + heading + 4),
            static_cast<float>(width - room_left - room_right), static_cast<float>(box.h - heading - 46)};
  if (panel.equal_scales) plot = with_equal_scales(plot, x, y);
  const auto pl = static_cast<double>(plot.x), pr = static_cast<double>(plot.right()), pt = static_cast<double>(plot.y),
             pb = static_cast<double>(plot.bottom());
  const Layout layout{panel, plot, AxisScale(panel.x, ex.lo, ex.hi, pl, pr), AxisScale(panel.y, ey.lo, ey.hi, pb, pt)};
  draw_axes(pen, layout);
  draw_all(pen, layout);
  draw_end_names(pen, layout, pr + 26);
}

} // namespace flipbook::render
