// SPDX-License-Identifier: MIT
// A number on every sample of a lattice, pads included, x fastest.
#pragma once

#include "sim/core/lattice.h"

#include <array>
#include <vector>

namespace flipbook {

template <class Real> using Field = std::vector<Real>; ///< indexed by Grid::at

/// One field for each velocity component.
template <int Dim, class Real> struct Components : std::array<Field<Real>, Dim> {
  void resize(const Grid<Dim>& grid) {
    for (auto& f : *this) f.assign(static_cast<std::size_t>(grid.size()), Real(0));
  }
};

} // namespace flipbook
