// SPDX-License-Identifier: MIT
// Where the particles say that liquid is: the level set around them, carried on into obstacles, and the cells that the
// next projection takes for liquid.
#pragma once

#include "sim/fluid/cells.h"
#include "sim/fluid/solids.h"

namespace flipbook {

template <int Dim, class Real> struct FluidState;

/// The particles must be in cell order.
template <int Dim, class Real>
void find_liquid(const Settings& settings, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                 const Solids<Dim, Real>& solids, const Particles<Dim, Real>& particles, const CellOrder<Dim>& order,
                 Field<Real>& phi, Cells<Dim, Real>& cells, Pool& pool);

/// What the next step will find: the particles of a state have moved since its last one.
template <int Dim, class Real> struct Liquid {
  Field<Real> phi;
  Cells<Dim, Real> cells;
};
template <int Dim, class Real> [[nodiscard]] Liquid<Dim, Real> liquid_now(const FluidState<Dim, Real>& s, Pool& pool);

} // namespace flipbook
