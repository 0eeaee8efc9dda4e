// SPDX-License-Identifier: MIT
#include "render/gui/pointer.h"

#include <algorithm>
#include <array>

namespace flipbook::render::gui {

Point pointer_at(Point target, double travel, float point) {
  const auto s = static_cast<float>(std::clamp(travel, 0.0, 1.0));
  const Point rest{target.x + 44 * point, target.y + 78 * point};
  // Bends a little: x leads, as a hand from below right would.
  const float lead = s * (2 - s);
  return {rest.x + (target.x - rest.x) * lead, rest.y + (target.y - rest.y) * s};
}

void draw_pointer(Ink& ink, Point tip, double travel, bool pressed) {
  const double seen = std::clamp(1.6 * travel, 0.0, 1.0);
  const Colour black = Colour::hex(0x0b0d10), white = Colour::hex(0xffffff);
  const auto at = [&](float x, float y) { return Point{tip.x + ink.pt(x), tip.y + ink.pt(y)}; };
  if (pressed) {
    ink.disc(tip, ink.pt(11), white.alpha(0.20 * seen));
    ink.disc(tip, ink.pt(10), black.alpha(0.14 * seen));
  }
  const Point nose = at(0, 0), left = at(0, 17.2F), notch = at(3.9F, 13.5F), foot = at(6.6F, 19.6F);
  const Point heel = at(9.2F, 18.5F), neck = at(6.6F, 12.5F), right = at(12.2F, 12.2F);
  const std::array outline{nose, left, notch, foot, heel, neck, right, nose, left};
  for (int i = 3; i >= 1; --i) { // a soft shadow
    std::array<Point, outline.size()> shadow = outline;
    for (Point& p : shadow) p = {p.x + ink.pt(1), p.y + ink.pt(1.5F)};
    ink.polyline(shadow, black.alpha(0.06 * seen), ink.pt(2.F + 2.F * static_cast<float>(i)));
  }
  ink.polyline(outline, black.alpha(seen), ink.pt(2.6F));
  const Colour fill = white.alpha(seen);
  ink.triangle(nose, neck, left, fill);
  ink.triangle(nose, right, neck, fill);
  ink.triangle(left, neck, notch, fill);
  ink.triangle(notch, neck, foot, fill);
  ink.triangle(foot, neck, heel, fill);
}

} // namespace flipbook::render::gui
