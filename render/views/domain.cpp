// SPDX-License-Identifier: MIT
#include "render/views/domain.h"

#include "render/views/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
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

constexpr float arrow_gap = 20, full_arrow = 21; // points

struct Arrow {
  gui::Point from, to;
};

/// A shaft, and a head in proportion where it would be seen; in a first pass the edge that keeps it apart from discs.
void draw_arrow(gui::Ink& ink, const Arrow& a, Colour c, float edge) {
  const float dx = a.to.x - a.from.x, dy = a.to.y - a.from.y, length = std::hypot(dx, dy);
  if (length <= 0) return;
  const float head = length < ink.pt(6) ? 0 : std::min(ink.pt(6), 0.34F * length), half = 0.42F * head;
  const float ux = dx / length, uy = dy / length;
  const gui::Point neck{a.to.x - head * ux, a.to.y - head * uy};
  const auto at = [&](float along, float across) {
    return gui::Point{neck.x + along * ux + across * uy, neck.y + along * uy - across * ux};
  };
  ink.line({a.from.x - edge * ux, a.from.y - edge * uy}, head > 0 ? neck : at(edge, 0), c, ink.pt(1.1F) + 2 * edge);
  if (head > 0) ink.triangle(at(head + 2 * edge, 0), at(-edge, half + 1.2F * edge), at(-edge, -half - 1.2F * edge), c);
}

void draw_all(gui::Ink& ink, std::span<const Arrow> arrows, const Palette& palette) {
  for (const Arrow& a : arrows) draw_arrow(ink, a, palette.page.alpha(0.7), ink.pt(0.8F));
  for (const Arrow& a : arrows) draw_arrow(ink, a, palette.arrow, 0);
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
  std::vector<float> speeds;
  for (const Pane& p : frame.panes) {
    const Snapshot& s = *p.snapshot;
    if (s.dim != 2) continue;
    for (std::size_t i = 0; i + 1 < s.v.size(); i += 2) speeds.push_back(std::hypot(s.v[i], s.v[i + 1]));
  }
  if (speeds.empty()) return 0;
  // Nine in ten are slower: were it the fastest drop, the arrows of the rest could not be seen.
  const auto tenth = speeds.end() - 1 - static_cast<std::ptrdiff_t>(speeds.size() / 10);
  std::nth_element(speeds.begin(), tenth, speeds.end());
  return *tenth > 0 ? round_up(static_cast<double>(*tenth)) : 0;
}

bool draw_arrows(gui::Ink& ink, const PaneView& pane, const Palette& palette, double full_speed) {
  const Snapshot& s = *pane.snapshot;
  const LatticeData *u = find_lattice(s, "u"), *v = find_lattice(s, "v");
  if (u == nullptr || v == nullptr) return false;
  if (full_speed <= 0) return true;
  const auto nx = static_cast<std::size_t>(s.cells[0]), ny = static_cast<std::size_t>(s.cells[1]);
  std::vector<char> wet(nx * ny, 0);
  for (std::size_t p = 0; p < s.particles(); ++p) {
    const double i = std::floor((s.x[2 * p] - s.lo[0]) / s.dx), j = std::floor((s.x[2 * p + 1] - s.lo[1]) / s.dx);
    if (i >= 0 && i < s.cells[0] && j >= 0 && j < s.cells[1])
      wet[static_cast<std::size_t>(i) + nx * static_cast<std::size_t>(j)] = 1;
  }
  // Middles of cells, thinned out until they are apart.
  const double cell = s.dx * static_cast<double>(pane.metre); // pixels; none in a picture too small for panes
  if (!(cell > 1e-3)) return true;
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(ink.pt(arrow_gap) / cell - 1e-3)));
  std::vector<Arrow> arrows;
  for (std::size_t j = stride / 2; j < ny; j += stride)
    for (std::size_t i = stride / 2; i < nx; i += stride) {
      if (wet[i + nx * j] == 0) continue;
      const double x = s.lo[0] + (static_cast<double>(i) + 0.5) * s.dx;
      const double y = s.lo[1] + (static_cast<double>(j) + 0.5) * s.dx;
      double dx = sample(*u, x, y) / full_speed, dy = -sample(*v, x, y) / full_speed;
      const double length = std::hypot(dx, dy), most = 1.4;
      if (!(length > 0.05)) continue;
      if (length > most) dx *= most / length, dy *= most / length;
      const gui::Point at = pane.pixel(x, y);
      const float hx = static_cast<float>(dx) * ink.pt(full_arrow) / 2,
                  hy = static_cast<float>(dy) * ink.pt(full_arrow) / 2;
      arrows.push_back({{at.x - hx, at.y - hy}, {at.x + hx, at.y + hy}});
    }
  ink.clip(pane.frame);
  draw_all(ink, arrows, palette);
  ink.unclip();
  return true;
}

float draw_arrow_key(gui::Ink& ink, const Rect& line, const Palette& palette, double full_speed) {
  const float length = ink.pt(full_arrow), y = std::round(line.middle_y()) + 0.5F;
  draw_all(ink, std::array{Arrow{{line.x, y}, {line.x + length, y}}}, palette);
  const std::string text = number(full_speed, 3) + " m/s";
  const float w = ink.fonts().width(gui::Type::small, text) + 1, x = line.x + length + ink.pt(7);
  ink.text({x, line.y, w, line.h}, gui::Type::small, palette.muted, text);
  return x + w + ink.pt(24) - line.x;
}

} // namespace flipbook::render
