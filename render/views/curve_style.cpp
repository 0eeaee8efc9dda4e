// SPDX-License-Identifier: MIT
#include "render/views/curve_style.h"

#include <array>
#include <cmath>
#include <numbers>

namespace flipbook::render {
namespace {

// In points.
constexpr float thickness = 1.8F, marker_radius = 3, marker_gap = 44;

const std::array<std::vector<float>, 6>& patterns() {
  static const std::array<std::vector<float>, 6> all{{
      {},                                // whole
      {6, 3},                            // dashed
      {2.5F, 2.3F},                      // dotted
      {7, 2.4F, 1.8F, 2.4F},             // dash, dot
      {12, 3},                           // long dashes
      {7, 2.4F, 1.8F, 2.4F, 1.8F, 2.4F}, // dash, dot, dot
  }};
  return all;
}

/// Of a marker of this radius; a disc has many.
std::vector<gui::Point> corners(gui::Point at, Marker marker, float radius) {
  const int n = marker == Marker::disc ? 20 : marker == Marker::triangle ? 3 : 4;
  const float turn = marker == Marker::square ? 0.25F : marker == Marker::triangle ? -0.5F : 0; // of a half
  const float size = marker == Marker::disc ? radius : radius * (marker == Marker::square ? 1.25F : 1.4F);
  std::vector<gui::Point> all;
  for (int k = 0; k < n; ++k) {
    const float angle = std::numbers::pi_v<float> * (turn + 2 * static_cast<float>(k) / static_cast<float>(n));
    all.push_back({at.x + size * std::cos(angle), at.y + size * std::sin(angle)});
  }
  return all;
}

/// Where the curve is at the places of its markers; each pane has its own, or equal curves would hide each other's.
std::vector<gui::Point> marker_places(const gui::Ink& ink, std::span<const gui::Point> points, std::size_t pane,
                                      float left) {
  std::vector<gui::Point> places;
  const float gap = ink.pt(marker_gap), first = left + gap * (0.3F + 0.1F * static_cast<float>(pane % 6));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const gui::Point a = points[i - 1], b = points[i];
    if (!(b.x > a.x)) continue;
    for (float k = std::max(0.F, std::ceil((a.x - first) / gap)); first + k * gap < b.x; ++k) {
      const float x = first + k * gap;
      places.push_back({x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)});
    }
  }
  return places;
}

} // namespace

Colour curve_colour(std::size_t pane, const Palette& palette) {
  return pane == no_pane ? palette.text : palette.variant(pane);
}

const CurveStyle& curve_style(std::size_t pane) {
  static const std::vector<CurveStyle> all = [] {
    constexpr std::array<Marker, 6> markers{Marker::disc,    Marker::square, Marker::triangle,
                                            Marker::diamond, Marker::disc,   Marker::square};
    std::vector<CurveStyle> styles;
    for (const auto& p : patterns()) styles.push_back({p, Marker::none});
    for (std::size_t i = 0; i < patterns().size(); ++i) styles.push_back({patterns()[i], markers[i]});
    return styles;
  }();
  return all[pane == no_pane ? 0 : pane % all.size()];
}

const CurveStyle& reference_line(std::size_t n) {
  return curve_style(n % patterns().size());
}

Marker reference_marker(std::size_t n) {
  constexpr std::array<Marker, 4> all{Marker::disc, Marker::square, Marker::triangle, Marker::diamond};
  return all[n % all.size()];
}

void draw_line(gui::Ink& ink, std::span<const gui::Point> points, const CurveStyle& style, Colour colour, float width) {
  if (style.pattern.empty()) return ink.polyline(points, colour, width);
  std::vector<float> pixels;
  for (const float p : style.pattern) pixels.push_back(ink.pt(p));
  ink.dashes(points, colour, width, pixels);
}

void draw_stroke(gui::Ink& ink, std::span<const gui::Point> points, std::size_t pane, const Palette& palette,
                 float left) {
  const CurveStyle& style = curve_style(pane);
  draw_line(ink, points, style, curve_colour(pane, palette), ink.pt(thickness));
  if (style.marker == Marker::none) return;
  for (const gui::Point& p : marker_places(ink, points, pane, left))
    draw_marker(ink, p, style.marker, ink.pt(marker_radius), curve_colour(pane, palette));
}

void draw_marker(gui::Ink& ink, gui::Point at, Marker marker, float radius, Colour colour) {
  if (marker != Marker::none) ink.convex(corners(at, marker, radius), colour);
}

void draw_hollow_marker(gui::Ink& ink, gui::Point at, Marker marker, float radius, Colour colour, Colour page) {
  if (marker == Marker::none) return;
  std::vector<gui::Point> outline = corners(at, marker, radius);
  ink.convex(outline, page);
  ink.loop(outline, colour, ink.pt(1.3F));
}

} // namespace flipbook::render
