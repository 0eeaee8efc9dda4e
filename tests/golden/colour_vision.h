// SPDX-License-Identifier: MIT
// What a reader without one kind of cone sees: the matrices of G. M. Machado, M. M. Oliveira and L. A. F. Fernandes, "A
// physiologically-based model for simulation of color vision deficiency", IEEE TVCG 15(6), 2009, at full severity, for
// linear sRGB.
#pragma once

#include "render/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::test {

struct ColourVision {
  const char* name;
  std::array<double, 9> matrix;
};

inline constexpr std::array<ColourVision, 4> colour_visions{{
    {"common", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"protanopia", {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}},
    {"deuteranopia", {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}},
    {"tritanopia", {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}},
}};

[[nodiscard]] inline double to_linear(std::uint8_t c) {
  const double x = c / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// The colour that looks to everybody as `c` looks to this reader.
[[nodiscard]] inline render::Colour seen(const ColourVision& by, render::Colour c) {
  const std::array rgb{to_linear(c.r), to_linear(c.g), to_linear(c.b)};
  const auto channel = [&](std::size_t row) {
    double x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += by.matrix[3 * row + k] * rgb[k];
    x = std::clamp(x, 0.0, 1.0);
    x = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * x));
  };
  return {channel(0), channel(1), channel(2), 255};
}

/// Of two colours on each other (WCAG 2): 1 to 21; 4.5 is enough for small text.
[[nodiscard]] inline double contrast(render::Colour a, render::Colour b) {
  const auto luminance = [](render::Colour c) {
    return 0.2126 * to_linear(c.r) + 0.7152 * to_linear(c.g) + 0.0722 * to_linear(c.b);
  };
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

} // namespace flipbook::test
