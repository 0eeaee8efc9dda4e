// SPDX-License-Identifier: MIT
#include "render/views/cell_types.h"

#include "render/views/lattice_pixels.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace flipbook::render {
namespace {

enum Kind { air, liquid, solid }; // as published

/// The kinds of cells, and where their corners are in the picture: whole pixels, so that no seams show.
class CellMap {
public:
  explicit CellMap(const PaneView& pane) : pane_(pane), cells_(*find_lattice(*pane.snapshot, "cells")) {}
  [[nodiscard]] int nx() const { return cells_.n[0]; }
  [[nodiscard]] int ny() const { return cells_.n[1]; }
  [[nodiscard]] int kind(int i, int j) const {
    const auto at = static_cast<std::size_t>(i) + static_cast<std::size_t>(nx()) * static_cast<std::size_t>(j);
    return static_cast<int>(cells_.values[at]);
  }
  [[nodiscard]] gui::Point corner(int i, int j) const {
    const auto at = [&](std::size_t axis, int n) {
      return static_cast<double>(cells_.origin[axis]) + (n - 0.5) * static_cast<double>(cells_.dx);
    };
    const gui::Point p = pane_.pixel(at(0, i), at(1, j));
    return {std::round(p.x), std::round(p.y)};
  }

private:
  const PaneView& pane_;
  const LatticeData& cells_;
};

Colour tint(int kind, const Palette& palette) {
  return kind == liquid ? palette.cell_liquid : kind == solid ? palette.cell_solid : palette.cell_air;
}

/// body(first, last + 1) for runs of equal `key(i)` along [0, n).
template <class Key, class Body> void each_run(int n, Key&& key, Body&& body) {
  for (int i = 0, next; i < n; i = next) {
    next = i + 1;
    while (next < n && key(next) == key(i)) ++next;
    body(i, next);
  }
}

/// Tints the cells whose kind is wanted, run by run.
template <class Wanted> void fill(gui::Ink& ink, const CellMap& cells, const Palette& palette, Wanted&& wanted) {
  for (int j = 0; j < cells.ny(); ++j)
    each_run(
        cells.nx(), [&](int i) { return cells.kind(i, j); },
        [&](int first, int end) {
          if (!wanted(cells.kind(first, j))) return;
          const gui::Point a = cells.corner(first, j + 1), b = cells.corner(end, j);
          ink.fill({a.x, a.y, b.x - a.x, b.y - a.y}, tint(cells.kind(first, j), palette));
        });
}

} // namespace

bool has_cell_types(const Snapshot& s) {
  return find_lattice(s, "cells") != nullptr;
}

void draw_cell_tints(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  fill(ink, CellMap(pane), palette, [](int kind) { return kind != solid; });
}

void draw_cell_borders(gui::Ink& ink, const PaneView& pane, const Palette& palette) {
  const CellMap cells(pane);
  fill(ink, cells, palette, [](int kind) { return kind == solid; });
  const float thickness = std::max(1.F, std::round(ink.pt(1))), before = std::floor(thickness / 2);
  const Colour colour = palette.arrow.alpha(0.85);
  for (int j = 1; j < cells.ny(); ++j)
    each_run(
        cells.nx(), [&](int i) { return cells.kind(i, j - 1) != cells.kind(i, j); },
        [&](int first, int end) {
          if (cells.kind(first, j - 1) == cells.kind(first, j)) return;
          const gui::Point a = cells.corner(first, j), b = cells.corner(end, j);
          ink.fill({a.x - before, a.y - before, b.x - a.x + thickness, thickness}, colour);
        });
  for (int i = 1; i < cells.nx(); ++i)
    each_run(
        cells.ny(), [&](int j) { return cells.kind(i - 1, j) != cells.kind(i, j); },
        [&](int first, int end) {
          if (cells.kind(i - 1, first) == cells.kind(i, first)) return;
          const gui::Point a = cells.corner(i, end), b = cells.corner(i, first); // a above b
          ink.fill({a.x - before, a.y - before, thickness, b.y - a.y + thickness}, colour);
        });
}

float draw_cell_key(gui::Ink& ink, const Rect& line, const Palette& palette) {
  constexpr std::array<std::pair<int, std::string_view>, 3> kinds{{{liquid, "liquid"}, {air, "air"}, {solid, "solid"}}};
  const float side = std::round(ink.pt(9)), y = std::round(line.middle_y() - side / 2);
  float x = line.x;
  for (const auto& [kind, name] : kinds) {
    const Rect square{std::round(x), y, side, side};
    ink.fill(square, palette.pane);
    ink.fill(square, tint(kind, palette));
    ink.frame(square, palette.muted, ink.hair());
    const float w = ink.fonts().width(gui::Type::small, name) + 1, text = square.right() + ink.pt(5);
    ink.text({text, line.y, w, line.h}, gui::Type::small, palette.muted, name);
    x = text + w + ink.pt(12);
  }
  return x + ink.pt(12) - line.x;
}

} // namespace flipbook::render
