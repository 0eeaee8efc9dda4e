// SPDX-License-Identifier: MIT
#include "render/views/arrows.h"

#include "render/views/lattice_pixels.h"
#include "render/views/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace flipbook::render {
namespace {

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

/// Which cells are liquid: those that hold a particle, or what the solver says.
class WetCells {
public:
  WetCells(const Snapshot& s, bool as_the_solver_says)
      : nx_(static_cast<std::size_t>(s.cells[0])), ny_(static_cast<std::size_t>(s.cells[1])), wet_(nx_ * ny_, 0) {
    const LatticeData* kinds = as_the_solver_says ? find_lattice(s, "cells") : nullptr;
    if (kinds != nullptr && kinds->values.size() == wet_.size()) {
      for (std::size_t i = 0; i < wet_.size(); ++i) wet_[i] = kinds->values[i] == 1;
      return;
    }
    for (std::size_t p = 0; p < s.particles(); ++p) {
      const double i = std::floor((static_cast<double>(s.x[2 * p]) - s.lo[0]) / s.dx);
      const double j = std::floor((static_cast<double>(s.x[2 * p + 1]) - s.lo[1]) / s.dx);
      if (i >= 0 && i < s.cells[0] && j >= 0 && j < s.cells[1])
        wet_[static_cast<std::size_t>(i) + nx_ * static_cast<std::size_t>(j)] = 1;
    }
  }
  /// Is one of the cells around this place (in cells), on whose border it may lie?
  [[nodiscard]] bool touch(double x, double y) const {
    constexpr double beside = 0.25;
    for (const double dx : {-beside, beside})
      for (const double dy : {-beside, beside}) {
        const double i = std::floor(x + dx), j = std::floor(y + dy);
        if (i >= 0 && j >= 0 && i < static_cast<double>(nx_) && j < static_cast<double>(ny_) &&
            wet_[static_cast<std::size_t>(i) + nx_ * static_cast<std::size_t>(j)] != 0)
          return true;
      }
    return false;
  }

private:
  std::size_t nx_, ny_;
  std::vector<char> wet_;
};

/// Gathers the arrows of a pane.
class Field {
public:
  Field(const gui::Ink& ink, const PaneView& pane, double full_speed, ArrowsAt at)
      : ink_(ink), pane_(pane), s_(*pane.snapshot), wet_(s_, at == ArrowsAt::faces), full_speed_(full_speed) {}

  /// The middle of this one is at a place (m) with this velocity (m/s).
  void add(double x, double y, double u, double v) {
    if (!wet_.touch((x - s_.lo[0]) / s_.dx, (y - s_.lo[1]) / s_.dx)) return;
    double dx = u / full_speed_, dy = -v / full_speed_;
    const double length = std::hypot(dx, dy), most = 1.4;
    if (!(length > 0.05)) return;
    if (length > most) dx *= most / length, dy *= most / length;
    const gui::Point at = pane_.pixel(x, y);
    const float hx = static_cast<float>(dx) * ink_.pt(full_arrow) / 2,
                hy = static_cast<float>(dy) * ink_.pt(full_arrow) / 2;
    arrows.push_back({{at.x - hx, at.y - hy}, {at.x + hx, at.y + hy}});
  }
  void in_cells(const LatticeData& u, const LatticeData& v, int stride) {
    for (int j = stride / 2; j < s_.cells[1]; j += stride)
      for (int i = stride / 2; i < s_.cells[0]; i += stride) {
        const double x = s_.lo[0] + (i + 0.5) * s_.dx, y = s_.lo[1] + (j + 0.5) * s_.dx;
        add(x, y, sample(u, x, y), sample(v, x, y));
      }
  }
  /// body(x, y, value) for the samples of a lattice.
  template <class Body> void on_samples(const LatticeData& l, int stride, Body&& body) {
    for (int j = stride / 2; j < l.n[1]; j += stride)
      for (int i = stride / 2; i < l.n[0]; i += stride) {
        const auto at = static_cast<std::size_t>(i) + static_cast<std::size_t>(l.n[0]) * static_cast<std::size_t>(j);
        const auto dx = static_cast<double>(l.dx);
        body(static_cast<double>(l.origin[0]) + i * dx, static_cast<double>(l.origin[1]) + j * dx, at);
      }
  }
  void on_faces(const LatticeData& u, const LatticeData& v, int stride) {
    const auto value = [](const LatticeData& l, std::size_t at) { return static_cast<double>(l.values[at]); };
    if (u.origin == v.origin && u.n == v.n) { // nodes
      on_samples(u, stride, [&](double x, double y, std::size_t at) { add(x, y, value(u, at), value(v, at)); });
      return;
    }
    on_samples(u, stride, [&](double x, double y, std::size_t at) { add(x, y, value(u, at), 0); });
    on_samples(v, stride, [&](double x, double y, std::size_t at) { add(x, y, 0, value(v, at)); });
  }

  std::vector<Arrow> arrows;

private:
  const gui::Ink& ink_;
  const PaneView& pane_;
  const Snapshot& s_;
  WetCells wet_;
  double full_speed_;
};

} // namespace

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

bool draw_arrows(gui::Ink& ink, const PaneView& pane, const Palette& palette, double full_speed, ArrowsAt at) {
  const Snapshot& s = *pane.snapshot;
  const LatticeData *u = find_lattice(s, "u"), *v = find_lattice(s, "v");
  if (u == nullptr || v == nullptr) return false;
  const double cell = s.dx * static_cast<double>(pane.metre); // pixels; none in a picture too small for panes
  if (full_speed <= 0 || !(cell > 1e-3)) return true;
  const int stride =
      static_cast<int>(std::clamp(std::ceil(static_cast<double>(ink.pt(arrow_gap)) / cell - 1e-3), 1.0, 1e6));
  Field field(ink, pane, full_speed, at);
  if (at == ArrowsAt::faces)
    field.on_faces(*u, *v, stride);
  else
    field.in_cells(*u, *v, stride);
  ink.clip(pane.frame);
  draw_all(ink, field.arrows, palette);
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
