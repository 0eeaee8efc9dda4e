// SPDX-License-Identifier: MIT
// Where the panes of a page lie in their boxes, what stands above them, and the pane of a difference.
#include "render/compose/page.h"
#include "render/views/domain.h"
#include "render/views/solids.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {

using gui::Type;

std::array<double, 2> extent_of(const Snapshot& s, const ViewSettings& view, bool turning) {
  return s.dim == 2 ? std::array{s.hi[0] - s.lo[0], s.hi[1] - s.lo[1]} : seen_shape(s, view, turning);
}

void Page::fit_texts(const gui::Fonts& fonts) {
  titles_.resize(frame_.panes.size());
  if (sheet_ && sheet_->named()) return;
  // A large pane has room that small ones lack: it does not share their type.
  std::vector<std::size_t> large, alike;
  for (std::size_t i = 0; i < frame_.panes.size(); ++i)
    (boxes_.large && boxes_.of_pane[i] == *boxes_.large ? large : alike).push_back(i);
  fit_titles_of(fonts, large);
  fit_titles_of(fonts, alike);
}

void Page::fit_titles_of(const gui::Fonts& fonts, const std::vector<std::size_t>& panes) {
  std::vector<std::string> titles;
  std::vector<float> widths;
  for (const std::size_t i : panes) {
    titles.push_back(frame_.panes[i].title);
    widths.push_back(line_of(i, box_of(i).title).w - (side_of(i) ? side_swatch * fonts.scale() : 0));
  }
  FittedTitles fitted = fit_titles(fonts, sheet_ ? Type::small : Type::strong, std::move(titles), widths);
  for (std::size_t k = 0; k < panes.size(); ++k) titles_[panes[k]] = {fitted.type, std::move(fitted.text[k])};
}

/// Of a pane's frame. Those of a sheet are named by their places.
Colour Page::colour_of(std::size_t pane) const {
  return sheet_ ? palette_.accent : palette_.variant(pane);
}

std::optional<std::size_t> Page::side_of(std::size_t pane) const {
  if (!split_ || (pane != split_->panes[0] && pane != split_->panes[1])) return std::nullopt;
  return pane == split_->panes[0] ? 0 : 1;
}

/// A pane's share of a line above or below its frame: two that share a frame share its width.
Rect Page::line_of(std::size_t pane, const Rect& line) const {
  const auto side = side_of(pane);
  if (!side) return line;
  const Rect& frame = box_of(pane).frame;
  const float half = std::floor(frame.w / 2) - layout_.panes.front().padding;
  return {*side == 0 ? line.x : frame.right() - half, line.y, half, line.h};
}

/// `whole`: whatever the settings zoom in on.
PaneView Page::placed(const Snapshot& s, const PaneBox& box, Colour colour, bool whole) const {
  const Rect room = box.frame.inset(box.padding);
  if (s.dim == 3) {
    const Rect window = box.frame.inset(2 * box.padding); // corners of a tank want more room than walls
    return {&s, box.frame, window, 0, colour, Camera(s, view_, frame_.turning, window)};
  }
  const auto [w, h] = extent_of(s, view_, false);
  const double zoom = whole ? 1 : view_.zoom;
  const double metre = zoom * std::min(static_cast<double>(room.w) / w, static_cast<double>(room.h) / h);
  const auto dw = static_cast<float>(metre * w), dh = static_cast<float>(metre * h);
  const auto left = static_cast<float>(whole ? 0.5 : view_.target[0]),
             above = static_cast<float>(whole ? 0.5 : 1 - view_.target[1]);
  const Rect domain{std::round(room.middle_x() - left * dw), std::round(room.middle_y() - above * dh), std::round(dw),
                    std::round(dh)};
  return {&s, box.frame, domain, static_cast<float>(metre), colour};
}

void Page::place_domains() {
  for (std::size_t i = 0; i < frame_.panes.size(); ++i)
    views_.push_back(placed(*frame_.panes[i].snapshot, box_of(i), colour_of(i), false));
  if (boxes_.split) {
    const PaneView& left = views_[(*boxes_.split)[0]];
    split_ = split_at(view_.arrangement.divider, *boxes_.split, left.frame, left.domain);
    for (std::size_t side = 0; side < 2; ++side) views_[(*boxes_.split)[side]].side = split_->side(side);
  }
  if (!difference_) return;
  const PaneBox& box = layout_.panes[*boxes_.difference]; // a camera is not for a plane
  difference_view_ = placed(difference_->plane(), box, palette_.muted, difference_->is_mean());
}

void Page::draw_behind_difference(gui::Ink& ink) const {
  if (difference_view_) ink.fill(difference_view_->frame, palette_.pane, ink.pt(4));
}

std::optional<Page::Stamp> Page::difference_pixels() const {
  if (!difference_view_) return std::nullopt;
  const Rect &f = difference_view_->frame, &d = difference_view_->domain;
  const auto whole = [](float x) { return static_cast<int>(std::round(x)); };
  const int x0 = whole(std::max(f.x + 1, d.x)), y0 = whole(std::max(f.y + 1, d.y));
  const Area area{x0, y0, whole(std::min(f.right() - 1, d.right())) - x0,
                  whole(std::min(f.bottom() - 1, d.bottom())) - y0};
  if (area.w <= 0 || area.h <= 0) return std::nullopt;
  return Stamp{area, difference_->pixels(*difference_view_, area)};
}

void Page::draw_difference(gui::Ink& ink) const {
  const PaneView& v = *difference_view_;
  const PaneBox& box = layout_.panes[*boxes_.difference];
  ink.clip(v.frame);
  difference_->draw_surfaces(ink, v);
  draw_solid_areas(ink, v, palette_);
  if (view_.walls && !difference_->is_mean()) draw_walls(ink, v, palette_);
  if (difference_->is_mean()) ink.frame(v.domain, palette_.far_edge, ink.hair());
  ink.unclip();
  ink.frame(v.frame, v.colour, std::round(ink.pt(2)), ink.pt(4));
  difference_->draw_title(ink, box.title);
  Rect line = box.caption;
  line.w = std::min(line.w, box.frame.w);
  difference_->draw_key(ink, line);
}

} // namespace flipbook::render
