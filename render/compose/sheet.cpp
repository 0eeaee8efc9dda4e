// SPDX-License-Identifier: MIT
#include "render/compose/sheet.h"

#include "render/view_settings.h"
#include "render/views/plots.h"
#include "render/views/ticks.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {

using gui::Align;
using gui::Type;

namespace {

// In points.
constexpr float margin = 20, header_gap = 14, gap = 9, widest_gap = 26, name_height = 18, name_gap = 12;
constexpr float pane_padding = 3, title_height = 15, least_curve = 15, most_curve = 30;
constexpr float curve_share = 0.2F, curve_gap = 3, dot = 2.4F;
// Curves beside their panes: how wide, in frames and at least, and how high.
constexpr float beside_share = 0.8F, most_beside = 1.4F, least_beside = 64, beside_gap = 12, beside_shape = 0.5F;
constexpr float widest_names = 0.16F; // of the picture

/// All values so far, and zero where it is near.
std::array<double, 2> range_of(const std::vector<const History::Column*>& columns) {
  double lo = INFINITY, hi = -INFINITY;
  for (const History::Column* c : columns) {
    if (!c) continue;
    for (const float y : c->y) {
      if (!std::isfinite(y)) continue;
      lo = std::min(lo, static_cast<double>(y));
      hi = std::max(hi, static_cast<double>(y));
    }
  }
  if (!(lo <= hi)) return {0, 1};
  if (lo > 0 && lo < 0.4 * hi) lo = 0;
  if (hi < 0 && hi > 0.4 * lo) hi = 0;
  if (hi - lo < 1e-9 * std::max(std::abs(lo), std::abs(hi)) || hi == lo) hi = lo + (lo == 0 ? 1 : 0.5 * std::abs(lo));
  return {lo, hi};
}

std::string label_of(std::string_view name) {
  for (const PlotName& p : plot_names())
    if (p.name == name) return std::string(p.label);
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

} // namespace

std::optional<Sparklines> sparklines_of(const Frame& frame, const ViewSettings& view) {
  const std::string& name = view.sheet.sparkline;
  Sparklines s;
  std::string unit;
  for (const Pane& p : frame.panes) {
    const History* h = p.snapshot->history.get();
    const History::Column* found = nullptr;
    if (h != nullptr && !name.empty())
      for (const History::Column& c : h->columns)
        if (c.name == name) found = &c, unit = c.unit;
    s.columns.push_back(found);
  }
  if (std::none_of(s.columns.begin(), s.columns.end(), [](auto* c) { return c != nullptr; })) return std::nullopt;
  const auto [lo, hi] = range_of(s.columns);
  const Ticks ticks = enclosing_ticks(lo, hi, 5); // from tick to tick, so that the axis moves seldom
  s.lo = ticks.at.front();
  s.hi = ticks.at.back();
  Prefix prefix;
  if (!unit.empty() && !unit.starts_with("kg")) prefix = si_prefix(std::max(std::abs(s.lo), std::abs(s.hi)));
  s.factor = prefix.factor;
  const std::string of = prefix.letter + unit_text(unit), space = of.empty() ? "" : " ";
  s.label = label_of(name) + ", from " + number(s.lo * s.factor, 4) + " to " + number(s.hi * s.factor, 4) + space + of;
  return s;
}

ContactSheet::ContactSheet(const Frame& frame, const ViewSettings& view, const gui::Fonts& fonts)
    : frame_(frame), fonts_(fonts), columns_(view.sheet.columns_of(frame.panes.size())),
      sparklines_(sparklines_of(frame, view)) {}

float ContactSheet::pt(float points) const {
  return std::round(points * fonts_.scale());
}

/// What the header, the footer and the panel leave, with room for the names at the left and above.
Rect ContactSheet::body_of(const LayoutRequest& r, const Layout& layout) const {
  const float top = layout.title.bottom() + pt(header_gap);
  const float bottom = layout.footer.h > 0 ? layout.footer.y - pt(8) : static_cast<float>(r.height) - pt(margin);
  const float right = layout.panel.w > 0 ? layout.panel.x - pt(18) : static_cast<float>(r.width) - pt(margin);
  const float above = frame_.sheet.columns.empty() ? 0 : pt(name_height);
  const float left = pt(margin) + gutter_;
  return {left, top + above, right - left, bottom - top - above};
}

ContactSheet::Grid ContactSheet::grid_in(const Rect& area, const LayoutRequest& r, bool beside) const {
  Grid g;
  g.beside = beside;
  const auto c = static_cast<float>(columns_), n = static_cast<float>(rows());
  const float cell_w = (area.w - (c - 1) * pt(gap)) / c, cell_h = (area.h - (n - 1) * pt(gap)) / n;
  g.padding = pt(pane_padding);
  g.title = named() ? 0 : pt(title_height);
  if (sparklines_ && !beside) g.curve_h = std::round(std::clamp(curve_share * cell_h, pt(least_curve), pt(most_curve)));
  float w = cell_w;
  if (beside) w = std::min((w - pt(beside_gap)) / (1 + beside_share), w - pt(beside_gap + least_beside));
  const float h = cell_h - g.title - g.curve_h - 2 * g.padding;
  const float metre = std::max(
      0.F, std::min((w - 2 * g.padding) / static_cast<float>(r.domain_width), h / static_cast<float>(r.domain_height)));
  g.frame_w = std::floor(metre * static_cast<float>(r.domain_width)) + 2 * g.padding;
  g.frame_h = std::floor(metre * static_cast<float>(r.domain_height)) + 2 * g.padding;
  if (beside) g.curve_w = std::floor(std::min(cell_w - g.frame_w, most_beside * g.frame_w + pt(beside_gap)));
  return g;
}

/// Below its pane, or beside it on its floor.
Rect ContactSheet::curve_of(const Grid& g, const Rect& frame) const {
  if (!g.beside) return {frame.x, frame.bottom(), frame.w, g.curve_h};
  const float w = g.curve_w - pt(beside_gap), h = std::min(frame.h, std::round(beside_shape * w));
  return {frame.right() + pt(beside_gap), frame.bottom() - h, w, h};
}

void ContactSheet::arrange(const LayoutRequest& r, Layout& layout) {
  for (const std::string& name : frame_.sheet.rows) gutter_ = std::max(gutter_, fonts_.width(Type::strong, name));
  gutter_ = std::min(std::ceil(gutter_), std::round(widest_names * static_cast<float>(r.width)));
  if (gutter_ > 0) gutter_ += pt(name_gap);
  number_ = sparklines_ ? std::ceil(fonts_.width(Type::small, "\xE2\x88\x92"
                                                              "88.8")) +
                              pt(2)
                        : 0;
  const Rect area = body_of(r, layout);
  Grid g = grid_in(area, r, false);
  if (sparklines_)
    if (const Grid beside = grid_in(area, r, true); beside.frame_h > 1.05F * g.frame_h) g = beside;
  beside_ = g.beside;
  const auto c = static_cast<float>(columns_), n = static_cast<float>(rows());
  const auto spread = [&](float spare, float gaps) {
    return gaps > 0 ? std::floor(std::clamp(spare / gaps, pt(gap), pt(widest_gap))) : 0;
  };
  const float gap_x = spread(area.w - c * g.width(), c - 1), gap_y = spread(area.h - n * g.height(), n - 1);
  const float used = c * g.width() + (c - 1) * gap_x;
  const float x0 = std::round(area.x + std::max(0.F, area.w - used) / 2);
  layout.panes.clear();
  for (std::size_t i = 0; i < frame_.panes.size(); ++i) {
    const float x = x0 + static_cast<float>(i % columns_) * (g.width() + gap_x);
    const float y = area.y + static_cast<float>(i / columns_) * (g.height() + gap_y);
    PaneBox box;
    box.padding = g.padding;
    if (g.title > 0) box.title = {x, y, g.width(), g.title};
    box.frame = {x, y + g.title, g.frame_w, g.frame_h};
    layout.panes.push_back(box);
    if (sparklines_) curves_.push_back(curve_of(g, box.frame));
  }
  place_names({x0, area.y, used, area.h}, g.width() + gap_x - pt(gap), layout);
}

/// `pitch`: what the name of a column may take.
void ContactSheet::place_names(const Rect& area, float pitch, const Layout& layout) {
  const auto frame_of = [&](std::size_t pane) { return layout.panes[pane].frame; };
  for (std::size_t row = 0; row < frame_.sheet.rows.size() && row < rows(); ++row) {
    const Rect f = frame_of(row * columns_);
    row_names_.push_back({area.x - gutter_, f.y, gutter_ - pt(name_gap), f.h});
  }
  for (std::size_t i = 0; i < frame_.sheet.columns.size() && i < columns_; ++i) {
    const Rect f = frame_of(i);
    const float x = beside_ ? f.x : f.middle_x() - pitch / 2;
    column_names_.push_back({x, area.y - pt(name_height), pitch, pt(name_height) - pt(2)});
  }
}

void ContactSheet::draw(gui::Ink& ink, const Palette& palette) const {
  for (std::size_t i = 0; i < row_names_.size(); ++i) {
    const Rect& r = row_names_[i];
    const std::vector<std::string> lines = fonts_.wrap(Type::strong, frame_.sheet.rows[i], r.w, 3);
    const float line = ink.pt(17), top = r.middle_y() - line * static_cast<float>(lines.size()) / 2;
    for (std::size_t k = 0; k < lines.size(); ++k)
      ink.text({r.x, top + line * static_cast<float>(k), r.w, line}, Type::strong, palette.text, lines[k],
               Align::right);
  }
  for (std::size_t i = 0; i < column_names_.size(); ++i) {
    const std::string& name = frame_.sheet.columns[i];
    const Type type = fonts_.width(Type::strong, name) <= column_names_[i].w ? Type::strong : Type::small;
    ink.text(column_names_[i], type, palette.text, name, beside_ ? Align::left : Align::centre);
  }
  for (std::size_t i = 0; i < curves_.size(); ++i) draw_curve(ink, i, palette);
}

/// Where the curve runs: its number stands behind it.
Rect ContactSheet::curve_area(std::size_t pane) const {
  const Rect& box = curves_[pane];
  const float side = pt(dot), top = pt(curve_gap + dot);
  return {box.x + side, box.y + top, box.w - 2 * side - number_, box.h - top - side};
}

void ContactSheet::draw_curve(gui::Ink& ink, std::size_t pane, const Palette& palette) const {
  const History::Column* column = sparklines_->columns[pane];
  if (!column || column->y.empty()) return;
  const Rect &box = curves_[pane], area = curve_area(pane);
  const std::vector<float>& t = frame_.panes[pane].snapshot->history->t;
  const double end = std::max({frame_.duration, frame_.time, 1e-9}), range = sparklines_->hi - sparklines_->lo;
  const auto at = [&](std::size_t k) {
    const double share = (static_cast<double>(column->y[k]) - sparklines_->lo) / range;
    return gui::Point{area.x + area.w * static_cast<float>(static_cast<double>(t[k]) / end),
                      area.bottom() - area.h * static_cast<float>(share)};
  };
  ink.line({area.x, area.bottom()}, {area.right(), area.bottom()}, palette.line, ink.hair());
  std::vector<gui::Point> points;
  const std::size_t rows = std::min(column->y.size(), t.size());
  std::size_t last = rows;
  for (std::size_t k = 0; k < rows; ++k) {
    if (!std::isfinite(column->y[k])) continue;
    last = k;
    const gui::Point p = at(k);
    if (points.empty() || p.x - points.back().x >= 0.5F) points.push_back(p);
  }
  if (last == rows) return; // no number yet
  if (points.size() > 1) ink.polyline(points, palette.variant(0), ink.pt(1.4F));
  ink.disc(at(last), ink.pt(dot), palette.variant(0));
  const float line = ink.pt(14),
              level = std::clamp(at(last).y, box.y + line / 2, std::max(box.bottom() - line / 2, box.y + line / 2));
  const Rect place{box.right() - number_, std::round(level - line / 2), number_, line};
  ink.text(place, Type::small, palette.muted, number(static_cast<double>(column->y[last]) * sparklines_->factor, 3),
           Align::right);
}

} // namespace flipbook::render
