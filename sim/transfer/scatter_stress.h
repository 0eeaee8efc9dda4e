// SPDX-License-Identifier: MIT
// Forces that stress exerts on the samples of the grid [Sulsky, Chen, Schreyer 1994], in the undeformed volume V0:
//   f_i = - sum_p V0_p tau_p grad w_ip            tau = P F^T, the Kirchhoff stress; grad by the particle's place
// and their form in MLS-MPM [Hu et al. 2018], which replaces grad w_ip by w_ip D_p^-1 (x_i - x_p):
//   f_i = - sum_p V0_p tau_p w_ip D_p^-1 r
// Both have no resultant and no moment: sum_i grad w_ip = 0 and sum_i w_ip r = 0, and for symmetric tau the moment
// sum_i x_i x f_i is that of the antisymmetric part of tau.
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/kernels/kernels.h"

#include <array>

namespace flipbook {

enum class Through { gradient, affine }; ///< grad w_ip, or w_ip D_p^-1 r

/// The upper triangle of V0 tau of each particle (J), row by row, one column for each entry.
template <int Dim, class Real> using StressColumns = std::array<const Real*, Dim*(Dim + 1) / 2>;

/// Clears f, then adds the forces (N) of all particles, which must be in cell order.
template <int Dim, class Real>
void scatter_stress(Through through, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                    const Particles<Dim, Real>& particles, const StressColumns<Dim, Real>& stress,
                    const CellOrder<Dim>& order, Components<Dim, Real>& f, Pool& pool);

} // namespace flipbook
