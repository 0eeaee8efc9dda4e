// SPDX-License-Identifier: MIT
#include "render/chart/series.h"

#include "render/theme.h"

#include <cmath>

namespace flipbook::render {

namespace {

using SeriesStyle = ChartSeries::Style;
constexpr double thin = 1.4, stroke = 2.1, radius = 4.2, level = 17;

/// Shapes differ as colours do, so that a print in grey can be read.
void draw_mark(Pen& pen, int shape, ChartPoint p, double r, Colour colour) {
  const auto outline = [&](std::initializer_list<ChartPoint> corners) {
    std::vector<ChartPoint> at;
    for (const ChartPoint& c : corners) at.push_back({p.x + r * c.x, p.y + r * c.y});
    pen.fill(at, colour);
  };
  switch (shape % 6) {
  case 1: return outline({{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}});
  case 2: return outline({{0, -1.2}, {1.15, .85}, {-1.15, .85}});
  case 3: return outline({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
  case 4: return outline({{0, 1.2}, {1.15, -.85}, {-1.15, -.85}});
  case 5:
    return outline({{-.4, -1.2},
                    {.4, -1.2},
                    {.4, -.4},
                    {1.2, -.4},
                    {1.2, .4},
                    {.4, .4},
                    {.4, 1.2},
                    {-.4, 1.2},
                    {-.4, .4},
                    {-1.2, .4},
                    {-1.2, -.4},
                    {-.4, -.4}});
  default: return pen.disc(p, r, colour);
  }
}

void draw_marks(Pen& pen, const ChartSeries& s, std::span<const ChartPoint> points) {
  const Colour colour = colour_of(s), page = palette(Theme::light).page;
  const int shape = s.colour == ChartSeries::exact ? 0 : s.colour;
  for (const ChartPoint& p : points) {
    if (!std::isfinite(p.x + p.y)) continue;
    draw_mark(pen, shape, p, radius + 1.3, page);
    draw_mark(pen, shape, p, radius, colour);
    if (shape >= 6) draw_mark(pen, shape, p, 0.5 * radius, page); // the same shapes once more, hollow
  }
}

bool has_line(SeriesStyle s) {
  return s == SeriesStyle::line || s == SeriesStyle::dashes || s == SeriesStyle::both;
}

/// Lines differ as colours do. Those with marks are solid, and those of exact curves dashed.
Dash dash_of(const ChartSeries& s) {
  using enum Dash;
  static constexpr std::array<Dash, 12> of_colour{long_dashes,  dash_dot, solid,        short_dashes,
                                                  dots,         dots,     dash_dot_dot, solid,
                                                  short_dashes, dash_dot, dashes,       dash_dot_dot};
  if (s.style == SeriesStyle::dashes) return dashes;
  if (s.style != SeriesStyle::line || s.colour == ChartSeries::exact) return solid;
  return of_colour[static_cast<std::size_t>(s.colour) % of_colour.size()];
}

} // namespace

Colour colour_of(const ChartSeries& s) {
  const Palette& light = palette(Theme::light);
  return s.colour == ChartSeries::exact ? light.text : light.variant(static_cast<std::size_t>(s.colour));
}

void draw_series(Pen& pen, const ChartSeries& s, std::span<const ChartPoint> points, std::span<const ChartPoint> lo,
                 std::span<const ChartPoint> hi) {
  const Colour colour = colour_of(s);
  if (has_line(s.style)) {
    const double width = s.colour == ChartSeries::exact ? thin : stroke;
    for (std::size_t begin = 0; begin < points.size();) {
      std::size_t end = begin;
      while (end < points.size() && std::isfinite(points[end].x + points[end].y)) ++end;
      if (end > begin + 1) pen.line(points.subspan(begin, end - begin), colour, width, dash_of(s));
      begin = end + 1;
    }
  }
  if (s.style == SeriesStyle::levels)
    for (const ChartPoint& p : points)
      pen.line(std::array<ChartPoint, 2>{{{p.x - level, p.y}, {p.x + level, p.y}}}, colour, 1.8);
  for (std::size_t i = 0; i < lo.size() && i < hi.size(); ++i) {
    constexpr double cap = 3;
    pen.line(std::array{lo[i], hi[i]}, colour, thin);
    for (const ChartPoint& end : {lo[i], hi[i]})
      pen.line(std::array<ChartPoint, 2>{{{end.x - cap, end.y}, {end.x + cap, end.y}}}, colour, thin);
  }
  if (s.style == SeriesStyle::points || s.style == SeriesStyle::both) draw_marks(pen, s, points);
}

void draw_sample(Pen& pen, const ChartSeries& s, ChartPoint at, double length) {
  const ChartPoint end{at.x + length, at.y}, middle{at.x + length / 2, at.y};
  const Colour colour = colour_of(s);
  if (s.style == SeriesStyle::levels) pen.line(std::array{at, end}, colour, 1.8);
  if (has_line(s.style))
    pen.line(std::array{at, end}, colour, s.colour == ChartSeries::exact ? thin : stroke, dash_of(s));
  if (s.style == SeriesStyle::points || s.style == SeriesStyle::both) draw_marks(pen, s, std::array{middle});
}

} // namespace flipbook::render
