// SPDX-License-Identifier: MIT
// The liquid of a snapshot as a level set, and the distance from its surface. Like the solvers' own (sim/fluid), from
// particles alone, so that every solver and every file of particles has one:
//   phi(x_c) = min_p |x_c - x_p| - r,   r = (sqrt(d)/4 + sqrt(d + 8)/4) spacing
#pragma once

#include "sim/frame/snapshot.h"

#include <array>
#include <cstddef>
#include <vector>

namespace flipbook::render {

/// The cells of a domain; in 2D the third axis has one.
struct CellGrid {
  int dim = 2;
  std::array<int, 3> n{1, 1, 1};
  std::array<double, 3> lo{0, 0, 0};
  double dx = 1;
  std::array<bool, 3> periodic{false, false, false};

  [[nodiscard]] std::size_t cells() const;
  [[nodiscard]] std::array<std::size_t, 3> strides() const;
};
[[nodiscard]] CellGrid grid_of(const Snapshot& s);

/// The liquid at the middles of the cells: below 0 inside. Exact up to dx, and no more than that.
[[nodiscard]] std::vector<float> liquid(const Snapshot& s, const CellGrid& grid);

/// The distance from the zero of `phi`, with its sign; empty where phi has no zero. Next to the surface it is what a
/// plane through the zeros between neighbouring cells gives; beyond, |grad d| = 1 [fast sweeping, Zhao 2005].
[[nodiscard]] std::vector<float> signed_distance(const std::vector<float>& phi, const CellGrid& grid);

} // namespace flipbook::render
