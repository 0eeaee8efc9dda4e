// SPDX-License-Identifier: MIT
// How curves differ in more than colour: the pattern of the line and the marker on it. Every variant has its own of the
// twelve pairs, so that a plot can be read in grey and by a reader to whom two colours are one.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"

#include <cstddef>
#include <span>
#include <vector>

namespace flipbook::render {

enum class Marker { none, disc, square, triangle, diamond };

struct CurveStyle {
  std::vector<float> pattern; ///< points (of type) along the curve, drawn and left out in turn; empty: a whole line
  Marker marker = Marker::none;
};

/// In place of a pane: the curve is about two of them together.
inline constexpr std::size_t no_pane = static_cast<std::size_t>(-1);
[[nodiscard]] Colour curve_colour(std::size_t pane, const Palette& palette);

/// Of the curves of a pane.
[[nodiscard]] const CurveStyle& curve_style(std::size_t pane);
/// Of the n-th reference of a plot; none of a pane looks like it, for it is grey and its markers are hollow.
[[nodiscard]] const CurveStyle& reference_line(std::size_t n);
[[nodiscard]] Marker reference_marker(std::size_t n);

/// A stretch of a pane's curve. Markers are at fixed places, counted from `left`, so that they stay while it grows.
void draw_stroke(gui::Ink& ink, std::span<const gui::Point> points, std::size_t pane, const Palette& palette,
                 float left);
void draw_line(gui::Ink& ink, std::span<const gui::Point> points, const CurveStyle& style, Colour colour,
               float thickness);
void draw_marker(gui::Ink& ink, gui::Point at, Marker marker, float radius, Colour colour);
/// Its outline, on the page's colour.
void draw_hollow_marker(gui::Ink& ink, gui::Point at, Marker marker, float radius, Colour colour, Colour page);

} // namespace flipbook::render
