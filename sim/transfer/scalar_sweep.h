// SPDX-License-Identifier: MIT
// The sweeps of transfer.h for a scheme written as plain scalar code: one call of its functions for each particle, and
// for each sample that it paints.
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/corner.h"
#include "sim/transfer/scalar.h"

#include <cstdint>
#include <vector>

namespace flipbook {

/// Adds to m and mu, which are cleared. Particles marked in `ballistic` paint nothing.
template <int Dim, class Real>
void scalar_p2g(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                const Particles<Dim, Real>& particles, const CellOrder<Dim>& order, Components<Dim, Real>& m,
                Components<Dim, Real>& mu, Pool& pool, const std::vector<std::uint8_t>* ballistic);

/// What a gather changes: all; v_p by sum w u and the memory by what it would be of a particle at rest; or the memory
/// alone.
enum class Take { all, increment, memory };

template <int Dim, class Real>
void scalar_g2p(Take take, const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                const Components<Dim, Real>& u, const Components<Dim, Real>& u_old, Particles<Dim, Real>& particles,
                Pool& pool, const std::vector<std::uint8_t>* ballistic);

} // namespace flipbook
