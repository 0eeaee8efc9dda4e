// SPDX-License-Identifier: MIT
// Draws lines and text in pixels; remembers where text went. Everything that is neither a particle nor a widget goes
// through it.
#pragma once

#include "render/gui/fonts.h"
#include "render/shapes.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

struct ImDrawList;
struct ImVec2;

namespace flipbook::render::gui {

struct Point {
  float x, y;
};

enum class Align { left, centre, right };

class Ink {
public:
  Ink(ImDrawList& list, const Fonts& fonts, std::vector<TextBox>& labels)
      : list_(&list), fonts_(&fonts), labels_(&labels) {}
  [[nodiscard]] const Fonts& fonts() const { return *fonts_; }
  [[nodiscard]] float pt(float points) const { return points * fonts_->scale(); } ///< in pixels
  /// A line that is crisp at any scale: a whole number of pixels, at least one.
  [[nodiscard]] float hair() const;

  /// One line of text in a box: centred vertically, aligned horizontally, shortened with an ellipsis where it is too
  /// long.
  void text(const Rect& box, Type t, Colour c, std::string_view text, Align align = Align::left);
  /// One line of text turned by `angle` (radians, clockwise) about its centre, `magnification` times as large; part of
  /// the ground rather than something to read: it may overlap other text.
  void slanted(Point centre, Type t, Colour c, std::string_view text, float magnification, float angle);
  void fill(const Rect& r, Colour c, float rounding = 0);
  void gradient(const Rect& r, Colour left, Colour right);
  /// The outline lies inside the rectangle.
  void frame(const Rect& r, Colour c, float thickness, float rounding = 0);
  void line(Point a, Point b, Colour c, float thickness);
  void polyline(std::span<const Point> points, Colour c, float thickness);
  /// `pattern`: lengths in pixels along the curve, drawn and left out in turn, again and again.
  void dashes(std::span<const Point> points, Colour c, float thickness, std::span<const float> pattern);
  void dashes(std::span<const Point> points, Colour c, float thickness, float on, float off);
  void disc(Point centre, float radius, Colour c);
  void ring(Point centre, float radius, Colour c, float thickness);
  void triangle(Point a, Point b, Point c, Colour colour);
  void convex(std::span<const Point> corners, Colour c);                ///< in either direction
  void loop(std::span<const Point> corners, Colour c, float thickness); ///< its outline
  /// Triangles that share their edges, three corners each; nothing shows where they meet.
  void mesh(std::span<const Point> corners, std::span<const std::uint32_t> triangles, Colour c);
  void clip(const Rect& r);
  void unclip();

private:
  ImDrawList* list_;
  const Fonts* fonts_;
  std::vector<TextBox>* labels_;
};

} // namespace flipbook::render::gui
