// SPDX-License-Identifier: MIT
#include "app/figures/page.h"

#include "render/theme.h"

#include <cmath>

namespace flipbook::app {

namespace {

using render::Pen;

constexpr double margin = 8, claim_size = 14, claim_line = 18.5, caption_size = 10.5, caption_line = 14.5;
constexpr double points_of_mm = 72 / 25.4, points_of_inch = 72;

/// Draws all of it; returns how high it is.
double draw_all(Pen& pen, const FigureSpec& spec, const FigureBody& body, const FigureLook& look, double width,
                ParticlePictures* pictures) {
  const render::Palette& light = render::palette(render::Theme::light);
  double y = margin;
  if (!look.bare) {
    for (const std::string& line : pen.wrapped(spec.claim, claim_size, width - 2 * margin, render::Weight::bold)) {
      pen.text({margin, y + claim_size - 2}, line, claim_size, light.text, render::Weight::bold);
      y += claim_line;
    }
    y += 6;
  }
  y = body.draw({pen, margin, y, width - 2 * margin, pictures});
  if (!look.bare) {
    y += 12;
    for (const std::string& line : pen.wrapped(spec.caption, caption_size, width - 2 * margin)) {
      pen.text({margin, y + caption_size - 1}, line, caption_size, light.muted);
      y += caption_line;
    }
  }
  return y + margin;
}

} // namespace

DrawnFigure draw_figure(const FigureSpec& spec, const FigureBody& body, const FigureLook& look, render::Medium medium,
                        double density, ParticlePictures& pictures) {
  DrawnFigure drawn;
  render::Sheet& sheet = drawn.sheet;
  sheet.width = look.width * points_of_mm / figure_unit;
  sheet.page = render::palette(render::Theme::light).page;
  sheet.unit = medium == render::Medium::pixels ? figure_unit * density / points_of_inch : figure_unit;
  sheet.medium = medium;
  sheet.title = render::plain_text(spec.claim);
  sheet.subject = render::plain_text(spec.caption);
  Pen measure(1, 1, 1, sheet.page);
  sheet.height = std::ceil(draw_all(measure, spec, body, look, sheet.width, nullptr));
  Pen pen(sheet);
  draw_all(pen, spec, body, look, sheet.width, &pictures);
  drawn.texts = pen.texts();
  if (medium == render::Medium::pixels)
    drawn.image = pen.image();
  else
    drawn.file = pen.file();
  return drawn;
}

} // namespace flipbook::app
