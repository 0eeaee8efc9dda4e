// SPDX-License-Identifier: MIT
#include "render/views/colour_bar.h"

#include "render/views/ticks.h"

#include <cmath>

namespace flipbook::render {
namespace {

/// Pressures are read in kPa rather than in 10000 Pa.
Prefix prefix_of(const ColourScale& scale) {
  if (scale.unit.empty() || scale.unit == "1/s") return {};
  const double largest = std::max(std::abs(scale.lo), std::abs(scale.hi));
  return largest >= 1e4 || largest < 1e-2 ? si_prefix(largest) : Prefix{};
}

} // namespace

std::string colour_bar_label(const ColourScale& scale) {
  std::string label(scale.quantity->label);
  if (!scale.unit.empty()) label += " (" + prefix_of(scale).letter + unit_text(scale.unit) + ")";
  return label;
}

void draw_colour_bar(gui::Ink& ink, const Rect& label, const Rect& bar, const ColourScale& scale,
                     const Palette& palette) {
  const float thickness = std::round(ink.pt(9));
  const float top = std::round(bar.y + ink.pt(4));
  ink.text({label.x, top - ink.pt(4), label.w, thickness + ink.pt(8)}, gui::Type::body, palette.muted,
           colour_bar_label(scale), gui::Align::right);
  const std::size_t n = scale.table.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const float x0 = bar.x + bar.w * static_cast<float>(i) / static_cast<float>(n - 1);
    const float x1 = bar.x + bar.w * static_cast<float>(i + 1) / static_cast<float>(n - 1);
    ink.gradient({x0, top, x1 - x0, thickness}, scale.table[i], scale.table[i + 1]);
  }
  const float tip = std::round(thickness * 0.7F);
  if (scale.below)
    ink.triangle({bar.x - tip, top + thickness / 2}, {bar.x, top}, {bar.x, top + thickness}, scale.table.front());
  if (scale.above)
    ink.triangle({bar.right() + tip, top + thickness / 2}, {bar.right(), top + thickness}, {bar.right(), top},
                 scale.table.back());
  if (scale.quantity->kind == MapKind::cyclic) return; // the colours name particles, not values
  const Prefix prefix = prefix_of(scale);
  const double lo = scale.lo * prefix.factor, hi = scale.hi * prefix.factor;
  const Ticks ticks = round_ticks(lo, hi, std::clamp(static_cast<int>(bar.w / ink.pt(36)), 2, 5));
  for (const double t : ticks.at) {
    const float x = bar.x + bar.w * static_cast<float>((t - lo) / (hi - lo));
    const float h = ink.hair();
    const float at = std::clamp(std::round(x - h / 2), bar.x, bar.right() - h) + h / 2;
    ink.line({at, top + thickness}, {at, top + thickness + ink.pt(3)}, palette.muted, h);
    const std::string text = tick_label(t, ticks.step);
    const float w = ink.fonts().width(gui::Type::small, text) + 1;
    ink.text({x - w / 2, top + thickness + ink.pt(3), w, ink.pt(13)}, gui::Type::small, palette.muted, text,
             gui::Align::centre);
  }
}

} // namespace flipbook::render
