// SPDX-License-Identifier: MIT
// The chunk layer of PNG: length (4 bytes, big endian), type (4), data, CRC-32 of type and data.
#pragma once

#include "app/encode/provenance.h"

#include <cstdint>
#include <span>
#include <vector>

namespace flipbook::app {

/// A PNG of 8 bits each of RGB around its compressed rows, with an sRGB chunk and the entries as iTXt chunks behind the
/// header, and a pHYs chunk where `density` (pixels of an inch) is not 0.
[[nodiscard]] std::vector<std::uint8_t> png_file(int width, int height, std::span<const std::uint8_t> pixels,
                                                 const TextEntries& text, double density = 0);

} // namespace flipbook::app
