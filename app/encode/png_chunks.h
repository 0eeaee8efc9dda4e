// SPDX-License-Identifier: MIT
// The chunk layer of PNG: length (4 bytes, big endian), type (4), data, CRC-32 of type and data.
#pragma once

#include "app/encode/provenance.h"

#include <cstdint>
#include <span>
#include <vector>

namespace flipbook::app {

/// The PNG with an sRGB chunk and the entries as iTXt chunks behind its header.
[[nodiscard]] std::vector<std::uint8_t> insert_text(std::span<const std::uint8_t> png, const TextEntries& text);

} // namespace flipbook::app
