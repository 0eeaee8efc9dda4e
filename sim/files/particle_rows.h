// SPDX-License-Identifier: MIT
// Particles as a file lists them: positions and velocities row by row, whatever the format. 2D input has z = 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipbook {

struct ParticleRows {
  std::vector<std::array<double, 3>> x; ///< metres
  std::vector<std::array<double, 3>> v; ///< m/s; as many as x
  std::vector<std::uint32_t> id;        ///< as many as x where they were asked for and the file has them; else none
  bool planar = false;                  ///< the file has no z

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

} // namespace flipbook
