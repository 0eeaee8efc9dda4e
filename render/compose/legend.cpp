// SPDX-License-Identifier: MIT
#include "render/compose/legend.h"

#include "render/compose/titles.h"
#include "render/views/curve_style.h"

#include <array>
#include <cmath>

namespace flipbook::render {
namespace {

/// In points: the sample of a line holds a whole period of every pattern, and just so where texts need the room.
struct Sample {
  float length, indent;
};
constexpr Sample usual{25, 31}, brief{18, 22};
constexpr float space = 21; // behind a text

} // namespace

Legend::Legend(const Frame& frame, std::span<const Plot> plots) {
  for (const Plot& p : plots)
    for (const Plot::Reference& r : p.references)
      if (r.number >= references_.size()) references_.push_back({r.curve->label, r.curve->style});
  if (plots.empty() || (frame.panes.size() < 2 && references_.empty())) return;
  for (const Pane& p : frame.panes) panes_.push_back(p.title);
}

std::vector<float> Legend::widths(const gui::Fonts& fonts) const {
  std::vector<float> all;
  const auto add = [&](const std::string& text) {
    all.push_back(std::ceil(fonts.width(gui::Type::small, text)) + std::round((usual.indent + space) * fonts.scale()));
  };
  for (const std::string& title : panes_) add(title);
  for (const Reference& r : references_) add(r.label);
  return all;
}

void Legend::draw(gui::Ink& ink, std::span<const Rect> boxes, const Palette& palette) const {
  if (boxes.empty()) return;
  bool fit = true;
  for (std::size_t i = 0; i < panes_.size(); ++i)
    fit = fit && ink.fonts().width(gui::Type::small, panes_[i]) <= boxes[i].w - std::round(ink.pt(usual.indent));
  const Sample& sample = fit ? usual : brief;
  const float aside = std::round(ink.pt(sample.indent)), length = std::round(ink.pt(sample.length));
  std::vector<float> rooms;
  for (const Rect& r : boxes.first(panes_.size())) rooms.push_back(r.w - aside);
  const FittedTitles titles = fit_titles(ink.fonts(), gui::Type::small, panes_, rooms);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Rect& r = boxes[i];
    const std::size_t n = i < panes_.size() ? i : i - panes_.size();
    const float y = std::round(r.middle_y());
    const std::array line{gui::Point{r.x, y}, gui::Point{r.x + length, y}};
    const gui::Point middle{r.x + length / 2, y};
    const Rect text{r.x + aside, r.y, r.w - aside, r.h};
    if (i < panes_.size()) {
      draw_line(ink, line, curve_style(n), palette.variant(n), ink.pt(1.8F));
      draw_marker(ink, middle, curve_style(n).marker, ink.pt(3), palette.variant(n));
      ink.text(text, gui::Type::small, palette.text, titles.text[n]);
      continue;
    }
    if (references_[n].style == ReferenceCurve::Style::line)
      draw_line(ink, line, reference_line(n), palette.muted, ink.pt(1.4F));
    else
      draw_hollow_marker(ink, middle, reference_marker(n), ink.pt(2.9F), palette.muted, palette.page);
    ink.text(text, gui::Type::small, palette.text, references_[n].label);
  }
}

} // namespace flipbook::render
