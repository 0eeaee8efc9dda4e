// SPDX-License-Identifier: MIT
// Particles move and deform with the velocity u of the grid after all forces:
//   x_p <- x_p + dt (sum_i w_ip u_i + beta (v_p - sum_i w_ip u_i))     with v_p after G2P; beta: see asflip.h
//   F_p <- (I + dt G_p) F_p,   G_p = sum_i u_i grad w_ip^T,  or sum_i w_ip u_i r^T D_p^-1 where forces are those of
//   MLS-MPM
// The gradient is the one that the forces act through, so that the work of the stress is what the grid loses. APIC's C
// is the second of the two: with MLS forces its particles move by what they hold already, as in MLS-MPM [Hu et al.
// 2018].
#pragma once

#include "sim/mpm/mpm_state.h"
#include "sim/transfer/scatter_stress.h"

namespace flipbook {

/// True if any particle met a wall; those are put back to just inside of it, or across a periodic side.
template <int Dim, class Real>
bool move_and_deform(const Corner& corner, Through through, KernelName kernel, const Grid<Dim>& grid,
                     const Walls<Dim, Real>& walls, const Components<Dim, Real>& u, double dt,
                     Particles<Dim, Real>& particles, Pool& pool);

} // namespace flipbook
