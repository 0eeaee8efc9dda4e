// SPDX-License-Identifier: MIT
// Pushes apart particles that came closer than the spacing d they were seeded with:
//   x_p <- x_p + strength sum_q 1/2 (d - |r|) r / |r|,   r = x_p - x_q,   over all q with |r| < d,
// every push taken from the positions before any of them (Jacobi), each particle moved by at most d / 4. Keeps liquid
// from clumping and thinning out; it moves particles without the flow, so it is off unless asked for.
#pragma once

#include "sim/fluid/walls.h"

#include "sim/core/order.h"

namespace flipbook {

/// The particles must be in cell order.
template <int Dim, class Real>
void correct_spacing(double strength, double spacing, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                     const CellOrder<Dim>& order, Particles<Dim, Real>& particles, Pool& pool);

} // namespace flipbook
