// SPDX-License-Identifier: MIT
// How large a mesh may be.
#pragma once

#include "sim/files/byte_source.h"

#include <cstdint>
#include <string>

namespace flipbook {

inline constexpr std::uint64_t most_triangles = 10'000'000, most_corners = 3 * most_triangles;

inline void refuse_too_many(std::uint64_t count, const char* what, std::uint64_t most, const ByteSource& file) {
  if (count > most)
    file.refuse(std::to_string(count) + " " + what + " are too many; at most " + std::to_string(most) +
                " are supported");
}

} // namespace flipbook
