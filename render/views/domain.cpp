// SPDX-License-Identifier: MIT
#include "render/views/domain.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace flipbook::render {

void draw_grid(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  const Snapshot& s = *pane.snapshot;
  int stride = 1;
  while (static_cast<float>(stride) * static_cast<float>(s.dx) * pane.metre < ink.pt(4)) stride *= 2;
  const float half = ink.hair() / 2;
  // A line over whole pixels, or neighbouring lines differ in strength.
  const auto crisp = [&](float at) { return std::round(at - half) + half; };
  for (int axis = 0; axis < 2; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (int i = 0; i <= s.cells[a]; i += stride) {
      const double at = s.lo[a] + i * s.dx;
      const gui::Point p = pane.pixel(axis == 0 ? at : s.lo[0], axis == 1 ? at : s.lo[1]);
      if (axis == 0)
        ink.line({crisp(p.x), pane.domain.y}, {crisp(p.x), pane.domain.bottom()}, palette.grid, ink.hair());
      else
        ink.line({pane.domain.x, crisp(p.y)}, {pane.domain.right(), crisp(p.y)}, palette.grid, ink.hair());
    }
  }
}

void draw_walls(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  const Rect f = pane.frame.inset(ink.pt(1)), d = pane.domain; // inside the rounded corners of the frame
  const std::array<bool, 3>& periodic = pane.snapshot->periodic;
  const float h = ink.hair() / 2;
  const auto side = [&](const Rect& solid, gui::Point a, gui::Point b, bool repeats) {
    if (repeats)
      ink.dashes(std::array{a, b}, palette.muted, ink.hair(), ink.pt(3), ink.pt(4));
    else
      ink.fill(solid, palette.wall);
  };
  side({f.x, f.y, d.x - f.x, f.h}, {d.x - h, d.y}, {d.x - h, d.bottom()}, periodic[0]);
  side({d.right(), f.y, f.right() - d.right(), f.h}, {d.right() + h, d.y}, {d.right() + h, d.bottom()}, periodic[0]);
  side({d.x, f.y, d.w, d.y - f.y}, {d.x, d.y - h}, {d.right(), d.y - h}, periodic[1]);
  side({d.x, d.bottom(), d.w, f.bottom() - d.bottom()}, {d.x, d.bottom() + h}, {d.right(), d.bottom() + h},
       periodic[1]);
}

} // namespace flipbook::render
