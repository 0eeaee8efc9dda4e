// SPDX-License-Identifier: MIT
#include "render/views/domain.h"

#include "render/views/ticks.h"

#include <array>
#include <cmath>
#include <vector>

namespace flipbook::render {
namespace {

const LatticeData* find_lattice(const Snapshot& s, std::string_view name) {
  for (const LatticeData& l : s.lattices)
    if (l.name == name) return &l;
  return nullptr;
}

/// Bilinear; positions outside take the nearest sample.
double sample(const LatticeData& l, double x, double y) {
  const double i = std::clamp((x - l.origin[0]) / l.dx, 0.0, l.n[0] - 1.0);
  const double j = std::clamp((y - l.origin[1]) / l.dx, 0.0, l.n[1] - 1.0);
  const int i0 = std::min(static_cast<int>(i), std::max(l.n[0] - 2, 0));
  const int j0 = std::min(static_cast<int>(j), std::max(l.n[1] - 2, 0));
  const auto at = [&](int a, int b) {
    a = std::min(a, l.n[0] - 1);
    b = std::min(b, l.n[1] - 1);
    return static_cast<double>(
        l.values[static_cast<std::size_t>(a) + static_cast<std::size_t>(l.n[0]) * static_cast<std::size_t>(b)]);
  };
  const double f = i - i0, g = j - j0;
  return (1 - g) * ((1 - f) * at(i0, j0) + f * at(i0 + 1, j0)) +
         g * ((1 - f) * at(i0, j0 + 1) + f * at(i0 + 1, j0 + 1));
}

void draw_arrow(gui::Ink& ink, gui::Point from, gui::Point to, const Palette& palette) {
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const float head = std::min(ink.pt(4), 0.6F * length), ux = dx / length, uy = dy / length;
  const gui::Point neck{to.x - head * ux, to.y - head * uy};
  const auto side = [&](float s, float grow) {
    return gui::Point{neck.x - grow * ux + s * uy, neck.y - grow * uy - s * ux};
  };
  const Colour halo = palette.page.alpha(0.75);
  const float edge = ink.pt(1);
  ink.line(from, neck, halo, ink.pt(3));
  ink.triangle({to.x + 2 * edge * ux, to.y + 2 * edge * uy}, side(0.5F * head + edge, edge),
               side(-0.5F * head - edge, edge), halo);
  ink.line(from, neck, palette.arrow, ink.pt(1.3F));
  ink.triangle(to, side(0.5F * head, 0), side(-0.5F * head, 0), palette.arrow);
}

} // namespace

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

double arrow_speed(const Frame& frame) {
  double fastest = 0;
  for (const Pane& p : frame.panes) {
    const Snapshot& s = *p.snapshot;
    if (s.dim != 2) continue;
    for (std::size_t i = 0; i + 1 < s.v.size(); i += 2)
      fastest = std::max(fastest, std::hypot(static_cast<double>(s.v[i]), static_cast<double>(s.v[i + 1])));
  }
  return fastest > 0 ? round_up(fastest) : 0;
}

bool draw_arrows(gui::Ink& ink, const PaneView& pane, const Palette& palette, double full_speed) {
  const Snapshot& s = *pane.snapshot;
  const LatticeData *u = find_lattice(s, "u"), *v = find_lattice(s, "v");
  if (u == nullptr || v == nullptr) return false;
  if (full_speed <= 0) return true;
  const float spacing = ink.pt(18);
  const int columns = std::max(1, static_cast<int>(pane.domain.w / spacing)),
            rows = std::max(1, static_cast<int>(pane.domain.h / spacing));
  const double width = (s.hi[0] - s.lo[0]) / columns, height = (s.hi[1] - s.lo[1]) / rows;
  std::vector<char> wet(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  const auto cell = [&](int i, int j) {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(columns) * static_cast<std::size_t>(j);
  };
  for (std::size_t p = 0; p < s.particles(); ++p) {
    const double i = std::floor((s.x[2 * p] - s.lo[0]) / width), j = std::floor((s.x[2 * p + 1] - s.lo[1]) / height);
    if (i >= 0 && i < columns && j >= 0 && j < rows) wet[cell(static_cast<int>(i), static_cast<int>(j))] = 1;
  }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      if (wet[cell(i, j)] == 0) continue;
      const double x = s.lo[0] + (i + 0.5) * width, y = s.lo[1] + (j + 0.5) * height;
      const auto longest = static_cast<double>(1.4F * spacing);
      const auto dx = static_cast<float>(sample(*u, x, y) / full_speed * longest);
      const auto dy = static_cast<float>(-sample(*v, x, y) / full_speed * longest);
      if (std::hypot(dx, dy) < ink.pt(1.5F)) continue;
      const gui::Point at = pane.pixel(x, y);
      draw_arrow(ink, {at.x - dx / 2, at.y - dy / 2}, {at.x + dx / 2, at.y + dy / 2}, palette);
    }
  return true;
}

} // namespace flipbook::render
