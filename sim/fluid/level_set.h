// SPDX-License-Identifier: MIT
// The liquid as a union of balls around the particles:
//   phi(x_c) = min_p |x_c - x_p| - r   at the cell centres,   r = (sqrt(d)/4 + sqrt(d + 8)/4) dx / per_axis
// With this radius the surface of a regular lattice of particles lies half a particle spacing outside its last row,
// where the liquid that the particles stand for ends: r is the mean of the distances from a cell centre just inside and
// just outside to the nearest particle, taken at two particles per axis and scaled with the spacing.
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/fluid/walls.h"

namespace flipbook {

/// The radius r.
template <int Dim> [[nodiscard]] double particle_radius(double dx, int per_axis);

/// Exact where |phi + r| < 2 dx; farther out phi is at least 2 dx - r. Pads are filled. The particles must be in cell
/// order.
template <int Dim, class Real>
void level_set(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Particles<Dim, Real>& particles,
               const CellOrder<Dim>& order, double radius, Field<Real>& phi, Pool& pool);

} // namespace flipbook
