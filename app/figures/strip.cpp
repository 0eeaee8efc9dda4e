// SPDX-License-Identifier: MIT
#include "app/figures/strip.h"

#include "app/figures/particle_pictures.h"
#include "app/figures/sketch.h"
#include "render/views/camera.h"
#include "render/views/colour_by.h"
#include "render/views/ticks.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

/// The walls that the window reaches, as a tank open above.
void draw_walls(render::Pen& pen, const render::Rect& box) {
  const auto left = static_cast<double>(box.x), right = static_cast<double>(box.right()),
             top = static_cast<double>(box.y), bottom = static_cast<double>(box.bottom());
  pen.outline(box, light().line, 0.8);
  pen.line(std::array<render::ChartPoint, 4>{{{left, top}, {left, bottom}, {right, bottom}, {right, top}}},
           light().accent, 1.3);
}

/// Height of a picture over its width.
double shape_of(const Strip& strip) {
  if (const Snapshot& first = *strip.shots.front().front(); first.dim == 3) {
    const auto [width, height] = seen_shape(first, strip.view, false);
    return height / width;
  }
  return (strip.window.hi[1] - strip.window.lo[1]) / (strip.window.hi[0] - strip.window.lo[0]);
}

void draw_shot(const FigureArea& area, const Strip& strip, const render::Rect& box, std::size_t r, std::size_t c) {
  const std::shared_ptr<const Snapshot>& shot = strip.shots[r][c];
  if (area.pictures && shot->dim == 3)
    area.pictures->draw(area.pen, box, shot, strip.view);
  else if (area.pictures)
    area.pictures->draw(area.pen, box, shot, strip.view, strip.window);
  if (strip.over) strip.over(area.pen, box, r, c);
  if (shot->dim == 3) return;
  if (strip.walls)
    draw_walls(area.pen, box);
  else
    area.pen.outline(box, light().line, 0.8);
}

/// A liquid drawn as one body has its own colour.
bool is_coloured(const Strip& strip) {
  const bool tinted = strip.view.space.tint && strip.shots.front().front()->dim == 3;
  return strip.view.look.style != render::Style::surface || chosen_quantity(strip.view).names || tinted;
}

} // namespace

double draw_strip(const FigureArea& area, const Strip& strip) {
  render::Pen& pen = area.pen;
  const bool beside = !area.narrow(); // names of rows: beside them, or above each
  constexpr double head = 17;
  double names = 0;
  if (beside)
    for (const std::string& r : strip.rows) names = std::max(names, pen.width(r, usual_text, render::Weight::bold));
  const double left = area.x + (names > 0 ? names + 12 : 0), gap = area.narrow() ? 4 : 7;
  const auto columns = static_cast<double>(strip.columns.size());
  const double wide = (area.right() - left - gap * (columns - 1)) / columns;
  const double high = wide * shape_of(strip);
  double y = area.y + head;
  for (std::size_t c = 0; c < strip.columns.size(); ++c)
    pen.text({left + (wide + gap) * static_cast<double>(c) + wide / 2, area.y + 11.5}, strip.columns[c], usual_text,
             light().text, render::Weight::regular, render::Align::centre);
  for (std::size_t r = 0; r < strip.shots.size(); ++r) {
    const std::string& name = strip.rows[r];
    if (beside && !name.empty())
      pen.text({area.x, y + high / 2 + 4}, name, usual_text, light().text, render::Weight::bold);
    else if (!name.empty())
      pen.text({area.x, (y += 15) - 3}, name, usual_text, light().text, render::Weight::bold);
    for (std::size_t c = 0; c < strip.shots[r].size(); ++c)
      draw_shot(area, strip, rect(left + (wide + gap) * static_cast<double>(c), y, wide, high), r, c);
    y += high + gap;
  }
  if (!is_coloured(strip)) return y - gap;
  const double bar = std::min(area.width, 210.0);
  return draw_colour_bar({pen, area.right() - bar, y + 3, bar, nullptr}, strip.view, bar);
}

double draw_colour_bar(const FigureArea& area, const render::ViewSettings& view, double width) {
  render::Pen& pen = area.pen;
  const render::ColourQuantity& quantity = chosen_quantity(view);
  const std::vector<render::Colour> colours = table(choose_map(view.map, quantity.kind, view.theme));
  render::Image ramp{static_cast<int>(colours.size()), 1, {}};
  for (const render::Colour& c : colours)
    for (const std::uint8_t part : {c.r, c.g, c.b, c.a}) ramp.rgba.push_back(part);
  const std::string unit = quantity.unit.empty() ? "" : " " + render::unit_text(quantity.unit);
  const std::string name(quantity.label), low = render::number(view.range[0], 3),
                                          high = render::number(view.range[1], 3) + unit;
  const double after = pen.width(high, small_text), before = pen.width(name + "  " + low, small_text);
  const double left = area.x + before + 7, right = area.x + width - after - 7, base = area.y + 10;
  pen.text({area.x, base}, name, small_text, light().text);
  pen.text({left - 7, base}, low, small_text, light().muted, render::Weight::regular, render::Align::right);
  pen.picture(ramp, rect(left, area.y + 2, right - left, 9));
  pen.outline(rect(left, area.y + 2, right - left, 9), light().accent, 0.7);
  pen.text({right + 7, base}, high, small_text, light().muted);
  return area.y + 14;
}

} // namespace flipbook::app
