// SPDX-License-Identifier: MIT
#include "render/compose/divider.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {

Rect Split::side(std::size_t i) const {
  return i == 0 ? Rect{frame.x, frame.y, at - frame.x, frame.h} : Rect{at, frame.y, frame.right() - at, frame.h};
}

double Split::position(float x) const {
  return to > from ? std::clamp(static_cast<double>((x - from) / (to - from)), 0.0, 1.0) : 0.5;
}

bool Split::near(gui::Point pixel, float reach) const {
  return std::abs(pixel.x - at) <= reach && pixel.y >= frame.y && pixel.y < frame.bottom();
}

Split split_at(double position, const std::array<std::size_t, 2>& panes, const Rect& frame, const Rect& domain) {
  Split s{panes, frame, std::max(frame.x, domain.x), std::min(frame.right(), domain.right()), 0};
  if (s.to < s.from) s.from = frame.x, s.to = frame.right(); // the domain was moved out of the frame
  s.at = std::round(s.from + static_cast<float>(position) * (s.to - s.from));
  // At an end nothing is left of a pane, not even its wall.
  if (position <= 0) s.at = frame.x;
  if (position >= 1) s.at = frame.right();
  return s;
}

void draw_divider(gui::Ink& ink, const Split& split, const std::array<Colour, 2>& colours, const Palette& palette) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Rect side = split.side(i);
    if (side.w <= 0) continue;
    ink.clip(side);
    ink.frame(split.frame, colours[i], std::round(ink.pt(2)), ink.pt(4));
    ink.unclip();
  }
  const float line = std::max(1.F, std::round(ink.pt(1.6F))), edge = std::max(1.F, std::round(ink.pt(1)));
  const Rect& f = split.frame;
  const float x = std::round(split.at - line / 2);
  ink.fill({x - edge, f.y, line + 2 * edge, f.h}, palette.page.alpha(0.55));
  ink.fill({x, f.y, line, f.h}, palette.text);
  const float r = std::min(ink.pt(9), f.h / 6), y = std::round(f.middle_y()), tip = 0.5F * r, half = 0.36F * r;
  const gui::Point c{x + line / 2, y};
  ink.disc(c, r + edge, palette.page.alpha(0.55));
  ink.disc(c, r, palette.text);
  for (const float way : {-1.F, 1.F}) // two arrows that point away from each other
    ink.convex(std::array{gui::Point{c.x + way * (tip + 0.22F * r), c.y}, gui::Point{c.x + way * 0.26F * r, c.y - half},
                          gui::Point{c.x + way * 0.26F * r, c.y + half}},
               palette.page);
}

} // namespace flipbook::render
