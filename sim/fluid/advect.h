// SPDX-License-Identifier: MIT
// Moves the particles along the grid's velocity, dx/dt = u(x), by an explicit Runge-Kutta method of order 1, 2
// (midpoint) or 3 [Ralston 1962]:
//   k1 = u(x),  k2 = u(x + dt/2 k1),  k3 = u(x + 3/4 dt k2),  x <- x + dt (2 k1 + 3 k2 + 4 k3) / 9
// Ballistic particles move with their own velocity, and lose what of it points into a wall they meet.
#pragma once

#include "sim/fluid/walls.h"
#include "sim/kernels/kernels.h"

#include <cstdint>
#include <vector>

namespace flipbook {

/// Where k1 = u(x) comes from: right after a G2P that only gathers, v_p holds it already.
enum class FirstStage { looked_up, own_velocity };

/// Returns whether a particle met a wall.
template <int Dim, class Real>
bool advect(Advection method, KernelName kernel, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
            const Components<Dim, Real>& u, double dt, const std::vector<std::uint8_t>& ballistic,
            Particles<Dim, Real>& particles, Pool& pool, FirstStage first = FirstStage::looked_up);

/// v <- v + dt g for ballistic particles, which no grid sees.
template <int Dim, class Real>
void accelerate_ballistic(const std::array<double, 3>& gravity, double dt, const std::vector<std::uint8_t>& ballistic,
                          Particles<Dim, Real>& particles, Pool& pool);

} // namespace flipbook
