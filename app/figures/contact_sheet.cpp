// SPDX-License-Identifier: MIT
#include "app/figures/contact_sheet.h"

#include "render/theme.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

constexpr int columns = 4, cell_width = 376, gap = 20, label = 22; // pixels

} // namespace

void ContactSheet::add(const FigureSpec& spec, const FigureBody& body, ParticlePictures& pictures) {
  constexpr double width = 174; // mm
  FigureSpec shown = spec;
  shown.caption.clear();
  const DrawnFigure drawn =
      draw_figure(shown, body, {.width = width}, render::Medium::pixels, cell_width / (width / 25.4), pictures);
  entries_.push_back({spec.name, drawn.image});
}

render::Image ContactSheet::image() const {
  const render::Palette& light = render::palette(render::Theme::light);
  // The next figure goes to the column that is shortest so far.
  std::vector<int> ends(columns, gap);
  std::vector<render::Area> places;
  for (const Entry& e : entries_) {
    const auto shortest = std::min_element(ends.begin(), ends.end());
    const auto column = static_cast<int>(shortest - ends.begin());
    places.push_back({gap + column * (cell_width + gap), *shortest + label, e.picture.width, e.picture.height});
    *shortest += label + e.picture.height + gap;
  }
  const int used = std::min(columns, std::max(1, static_cast<int>(entries_.size())));
  render::Pen pen(used * (cell_width + gap) + gap, *std::max_element(ends.begin(), ends.end()), 1, light.page);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const render::Area& place = places[i];
    const render::Rect box = place.rect();
    pen.text({static_cast<double>(place.x), place.y - 7.0}, entries_[i].name, 12, light.muted, render::Weight::bold);
    pen.picture(entries_[i].picture, box);
    pen.outline(box, light.line, 1);
  }
  return pen.image();
}

} // namespace flipbook::app
