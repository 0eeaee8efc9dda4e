// SPDX-License-Identifier: MIT
#include "render/views/watermark.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook::render {

void draw_watermark(gui::Ink& ink, const Rect& pane, const std::string& text, const Palette& palette) {
  using gui::Type;
  const gui::Fonts& fonts = ink.fonts();
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string words = text.substr(0, colon);
  const Rect inner = pane.inset(std::round(ink.pt(2)));
  const Rect banner{inner.x, inner.y, inner.w, std::min(std::round(ink.pt(21)), inner.h / 3)};
  const Rect rest{inner.x, banner.bottom(), inner.w, inner.bottom() - banner.bottom()};
  ink.clip(rest);
  // Along the diagonal, as large as fits.
  const float room = 0.8F * std::hypot(rest.w, rest.h), width = fonts.width(Type::title, words);
  const float magnification = std::min(room / std::max(width, 1.F), 4.F), angle = -std::atan2(rest.h, rest.w);
  const float x = rest.middle_x(), y = rest.middle_y(), edge = std::max(1.F, ink.pt(1.5F));
  // Grey with a shadow: whatever the particles' colours, one of the two stands out.
  ink.slanted({x + edge, y + edge}, Type::title, palette.pane.alpha(0.45), words, magnification, angle);
  ink.slanted({x, y}, Type::title, palette.text.alpha(0.4), words, magnification, angle);
  ink.unclip();
  ink.fill(banner, palette.warning);
  // What is told last is what only the banner says.
  const std::string tail = colon + 2 < text.size() ? text.substr(colon + 2) : words;
  const Rect line = banner.inset(std::round(ink.pt(3)));
  std::pair<Type, std::string> said{Type::small, tail};
  for (const auto& form : {std::pair{Type::body, text}, std::pair{Type::small, text}, std::pair{Type::body, tail}})
    if (fonts.width(form.first, form.second) <= line.w) {
      said = form;
      break;
    }
  ink.text(line, said.first, palette.pane, said.second, gui::Align::centre);
}

} // namespace flipbook::render
