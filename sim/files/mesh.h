// SPDX-License-Identifier: MIT
// Triangles as a file lists them, in the file's own coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace flipbook {

struct Mesh {
  std::vector<std::array<double, 3>> vertices;         ///< no two at the same place
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< three different vertices each
};

} // namespace flipbook
