// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipbook::render {

/// RGBA, 8 bits each, sRGB, top row first.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  [[nodiscard]] std::size_t bytes() const { return rgba.size(); }
};

} // namespace flipbook::render
