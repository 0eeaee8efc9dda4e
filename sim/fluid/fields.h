// SPDX-License-Identifier: MIT
// Quantities on the grid, as particles and images are coloured by them.
#pragma once

#include "sim/fluid/fluid_state.h"
#include "sim/frame/snapshot.h"

#include <array>

namespace flipbook {

/// Multilinear interpolation of a lattice with the given origin (in cells).
template <int Dim, class Real>
[[nodiscard]] Real sample(const Grid<Dim>& grid, const Vec<Dim, Real>& origin, const Field<Real>& f,
                          const Vec<Dim, Real>& x) {
  Index<Dim> base;
  Vec<Dim, Real> fraction;
  for (int d = 0; d < Dim; ++d) {
    const Real q = grid_position(x[d], static_cast<Real>(1 / grid.dx)) - origin[d];
    base[d] = static_cast<int>(q);
    fraction[d] = q - static_cast<Real>(base[d]);
  }
  Real sum = 0;
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    Real weight = 1;
    std::ptrdiff_t at = grid.at(base);
    for (int d = 0; d < Dim; ++d) {
      const bool upper = corner >> d & 1;
      weight *= upper ? fraction[d] : 1 - fraction[d];
      if (upper) at += grid.stride(d);
    }
    sum += weight * f[static_cast<std::size_t>(at)];
  }
  return sum;
}

/// curl u on the edges of the cells (2D: on the nodes), where the MAC faces give it by one difference on each axis.
template <int Dim, class Real>
[[nodiscard]] std::array<Field<Real>, spin<Dim>> curl(const FluidState<Dim, Real>& s, Pool& pool);

/// Pressure at cell centres (Pa), pads filled: 0 in air; in solids what the liquid beside them has.
template <int Dim, class Real> [[nodiscard]] Field<Real> pressure_field(const FluidState<Dim, Real>& s, Pool& pool);

/// div u of the liquid cells (1/s), pads filled, as the last projection and what came after it left it; in other cells
/// what the liquid beside them has.
template <int Dim, class Real> [[nodiscard]] Field<Real> divergence_field(const FluidState<Dim, Real>& s, Pool& pool);

/// What a request asks for of fields, of the surface and of the kinds of cells, in 2D. The speed is given at every half
/// cell.
template <int Dim, class Real>
[[nodiscard]] std::vector<LatticeData> image_lattices(const FluidState<Dim, Real>& s, const FrameRequest& request,
                                                      Pool& pool);

} // namespace flipbook
