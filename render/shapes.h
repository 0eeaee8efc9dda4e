// SPDX-License-Identifier: MIT
// Rectangles in pixels (y down) and colours.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace flipbook::render {

struct Rect {
  float x = 0, y = 0, w = 0, h = 0;
  [[nodiscard]] float right() const { return x + w; }
  [[nodiscard]] float bottom() const { return y + h; }
  [[nodiscard]] float middle_x() const { return x + w / 2; }
  [[nodiscard]] float middle_y() const { return y + h / 2; }
  [[nodiscard]] Rect inset(float by) const {
    return {x + by, y + by, std::max(0.f, w - 2 * by), std::max(0.f, h - 2 * by)};
  }
  [[nodiscard]] bool overlaps(const Rect& o) const {
    return x < o.right() && o.x < right() && y < o.bottom() && o.y < bottom();
  }
};

/// Whole pixels.
struct Area {
  int x = 0, y = 0, w = 0, h = 0;
  [[nodiscard]] Rect rect() const {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(w), static_cast<float>(h)};
  }
};

/// sRGB.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  [[nodiscard]] constexpr Colour alpha(double share) const {
    return {r, g, b, static_cast<std::uint8_t>(share * 255 + 0.5)};
  }
  /// Dear ImGui's packing.
  [[nodiscard]] constexpr std::uint32_t packed() const {
    return std::uint32_t{r} | std::uint32_t{g} << 8U | std::uint32_t{b} << 16U | std::uint32_t{a} << 24U;
  }
  [[nodiscard]] static constexpr Colour hex(std::uint32_t rgb) {
    return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U & 255U),
            static_cast<std::uint8_t>(rgb & 255U), 255};
  }
};

/// Where a text was drawn: tests ask that no two overlap and none leaves the picture.
struct TextBox {
  Rect box;
  std::string text;
};

} // namespace flipbook::render
