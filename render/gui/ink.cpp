// SPDX-License-Identifier: MIT
#include "render/gui/ink.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace flipbook::render::gui {

static ImVec2 vec(Point p) {
  return {p.x, p.y};
}

float Ink::hair() const {
  return std::max(1.F, std::round(fonts_->scale()));
}

void Ink::text(const Rect& box, Type t, Colour c, std::string_view text, Align align) {
  const std::string shown = fonts_->fit(t, text, box.w);
  if (shown.empty()) return;
  const float width = fonts_->width(t, shown), height = fonts_->size(t);
  const float slack = align == Align::left ? 0 : align == Align::right ? box.w - width : (box.w - width) / 2;
  // Whole pixels, or the glyphs blur.
  const float x = std::floor(box.x + slack), y = std::round(box.y + (box.h - height) / 2);
  list_->AddText(fonts_->font(t), height, {x, y}, c.packed(), shown.data(), shown.data() + shown.size());
  labels_->push_back({{x, y, width, height}, shown});
}

void Ink::slanted(Point centre, Type t, Colour c, std::string_view words, float magnification, float angle) {
  const std::string text = fonts_->drawable(words);
  const int first = list_->VtxBuffer.Size;
  const float width = magnification * fonts_->width(t, text), height = magnification * fonts_->size(t);
  list_->AddText(fonts_->font(t), height, {centre.x - width / 2, centre.y - height / 2}, c.packed(), text.data(),
                 text.data() + text.size());
  const float cosine = std::cos(angle), sine = std::sin(angle);
  for (int i = first; i < list_->VtxBuffer.Size; ++i) {
    ImVec2& at = list_->VtxBuffer[i].pos;
    const float x = at.x - centre.x, y = at.y - centre.y;
    at = {centre.x + cosine * x - sine * y, centre.y + sine * x + cosine * y};
  }
}

void Ink::fill(const Rect& r, Colour c, float rounding) {
  list_->AddRectFilled({r.x, r.y}, {r.right(), r.bottom()}, c.packed(), rounding);
}

void Ink::gradient(const Rect& r, Colour left, Colour right) {
  list_->AddRectFilledMultiColor({r.x, r.y}, {r.right(), r.bottom()}, left.packed(), right.packed(), right.packed(),
                                 left.packed());
}

void Ink::frame(const Rect& r, Colour c, float thickness, float rounding) {
  const float h = thickness / 2;
  list_->PathRect({r.x + h, r.y + h}, {r.right() - h, r.bottom() - h}, rounding);
  list_->PathStroke(c.packed(), ImDrawFlags_Closed, thickness);
}

void Ink::line(Point a, Point b, Colour c, float thickness) {
  polyline(std::array{a, b}, c, thickness);
}

void Ink::polyline(std::span<const Point> points, Colour c, float thickness) {
  for (const Point& p : points) list_->PathLineTo(vec(p));
  list_->PathStroke(c.packed(), 0, thickness);
}

void Ink::dashes(std::span<const Point> points, Colour c, float thickness, std::span<const float> pattern) {
  std::size_t part = 0;
  float left = pattern[0]; // of this part
  std::vector<Point> dash;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point a = points[i - 1], b = points[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    float done = 0;
    while (done < length) {
      const bool drawing = part % 2 == 0;
      const float step = std::min(length - done, left);
      const auto at = [&](float s) { return Point{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length}; };
      if (drawing && dash.empty()) dash.push_back(at(done));
      done += step;
      left -= step;
      if (drawing) dash.push_back(at(done));
      if (left > 0) continue;
      if (drawing) polyline(dash, c, thickness);
      dash.clear();
      part = (part + 1) % pattern.size();
      left = pattern[part];
    }
  }
  if (dash.size() > 1) polyline(dash, c, thickness);
}

void Ink::dashes(std::span<const Point> points, Colour c, float thickness, float on, float off) {
  dashes(points, c, thickness, std::array{on, off});
}

void Ink::disc(Point centre, float radius, Colour c) {
  list_->AddCircleFilled(vec(centre), radius, c.packed(), 32);
}

void Ink::ring(Point centre, float radius, Colour c, float thickness) {
  list_->AddCircle(vec(centre), radius, c.packed(), 48, thickness);
}

void Ink::triangle(Point a, Point b, Point c, Colour colour) {
  list_->AddTriangleFilled(vec(a), vec(b), vec(c), colour.packed());
}

void Ink::convex(std::span<const Point> corners, Colour c) {
  // Dear ImGui smooths the edges of polygons that turn clockwise.
  float twice_area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    twice_area += a.x * b.y - b.x * a.y;
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    list_->PathLineTo(vec(twice_area >= 0 ? corners[i] : corners[corners.size() - 1 - i]));
  list_->PathFillConvex(c.packed());
}

void Ink::loop(std::span<const Point> corners, Colour c, float thickness) {
  for (const Point& p : corners) list_->PathLineTo(vec(p));
  list_->PathStroke(c.packed(), ImDrawFlags_Closed, thickness);
}

void Ink::mesh(std::span<const Point> corners, std::span<const std::uint32_t> triangles, Colour c) {
  const ImDrawListFlags before = list_->Flags;
  list_->Flags &= ~ImDrawListFlags_AntiAliasedFill; // smoothed edges would show as a net
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    triangle(corners[triangles[t]], corners[triangles[t + 1]], corners[triangles[t + 2]], c);
  list_->Flags = before;
}

void Ink::clip(const Rect& r) {
  list_->PushClipRect({r.x, r.y}, {r.right(), r.bottom()}, true);
}
void Ink::unclip() {
  list_->PopClipRect();
}

} // namespace flipbook::render::gui
