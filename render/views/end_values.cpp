// SPDX-License-Identifier: MIT
#include "render/views/end_values.h"

#include "render/views/curve_style.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {
namespace {

constexpr float beside_dot = 9; // points

/// The variant's colour with enough of the text's to be read in small letters.
Colour readable(Colour c, Colour text) {
  const auto mix = [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((3 * a + 2 * b) / 5); };
  return {mix(c.r, text.r), mix(c.g, text.g), mix(c.b, text.b), 255};
}

} // namespace

/// Isotonic regression of wanted[i] - i gap by joining neighbours that are out of order, then clamped.
std::vector<float> apart(std::span<const float> wanted, float gap, float lo, float hi) {
  struct Block {
    float sum;
    std::size_t count;
    [[nodiscard]] float mean() const { return sum / static_cast<float>(count); }
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    blocks.push_back({wanted[i] - static_cast<float>(i) * gap, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().count += last.count;
    }
  }
  const float most = hi - static_cast<float>(wanted.empty() ? 0 : wanted.size() - 1) * gap;
  std::vector<float> places;
  for (const Block& b : blocks)
    for (std::size_t k = 0; k < b.count; ++k)
      places.push_back(std::clamp(b.mean(), lo, most) + static_cast<float>(places.size()) * gap);
  return places;
}

float end_value_gap(const gui::Ink& ink) {
  return std::ceil(ink.fonts().size(gui::Type::small)) + 1;
}

float end_value_room(const gui::Ink& ink, float width) {
  return std::ceil(width + ink.pt(beside_dot)) + 1;
}

void draw_end_values(gui::Ink& ink, std::vector<EndValue> values, const Rect& area, const Palette& palette) {
  std::stable_sort(values.begin(), values.end(), [](auto& a, auto& b) { return a.dot.y < b.dot.y; });
  std::vector<float> wanted;
  for (const EndValue& v : values) wanted.push_back(v.dot.y);
  const float gap = end_value_gap(ink), half = gap / 2;
  const std::vector<float> places = apart(wanted, gap, area.y + half, area.bottom() - half);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const EndValue& v = values[i];
    const float x = v.dot.x + ink.pt(beside_dot), y = std::round(places[i]);
    if (std::abs(y - v.dot.y) > ink.pt(2))
      ink.line({v.dot.x + ink.pt(3), v.dot.y}, {x - ink.pt(1.5F), y}, curve_colour(v.pane, palette), ink.hair());
    const float width = std::ceil(ink.fonts().width(gui::Type::small, v.text)) + 1;
    ink.fill({x - ink.pt(1), y - half, width + ink.pt(2), gap}, palette.page.alpha(0.75), ink.pt(2));
    ink.text({x, y - half, width, gap}, gui::Type::small, readable(curve_colour(v.pane, palette), palette.text),
             v.text);
  }
}

} // namespace flipbook::render
