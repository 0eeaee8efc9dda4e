// SPDX-License-Identifier: MIT
// Carries face velocities from where they are known into the air around, layer by layer: a face of the next layer takes
// the mean of its known neighbours. Particles near the surface, and those that cross it within a step, interpolate
// there.
#pragma once

#include "sim/core/field.h"
#include "sim/fluid/walls.h"

#include <cstdint>
#include <vector>

namespace flipbook {

/// Which faces are known, one byte each: 1 or 0, and 0 in the pads.
template <int Dim> struct Known : std::array<std::vector<std::uint8_t>, Dim> {
  void resize(const Grid<Dim>& grid) {
    for (auto& bytes : *this) bytes.resize(static_cast<std::size_t>(grid.size()));
  }
  std::array<std::vector<std::uint8_t>, Dim> next{}; ///< room for extrapolate(): the layer that it works on
};

/// Faces farther than `layers` from a known one keep what they have. `known` is used up.
template <int Dim, class Real>
void extrapolate(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, Known<Dim>& known, int layers,
                 Components<Dim, Real>& u, Pool& pool);

} // namespace flipbook
