// SPDX-License-Identifier: MIT
// The energy account of a run, in joules (J/m in 2D). A transfer there and back costs
//   loss = (T_particles - T_grid) before + (T_grid - T_particles) after,
// kinetic energies T as sim/diagnostics/ledger.h defines them: what the grid did in between (gravity, pressure, walls)
// cancels, so that the number is the transfer's own. Positive: lost. FLIP-like schemes can gain.
#pragma once

#include "sim/diagnostics/ledger.h"
#include "sim/fluid/fluid_state.h"

namespace flipbook {

/// What the columns of a history hold.
template <int Dim> struct EnergyAccount {
  Totals<Dim> totals;   ///< of the particles
  double potential = 0; ///< -sum m g . x, zero at the lower corner of the domain
};

template <int Dim, class Real>
[[nodiscard]] EnergyAccount<Dim> energy_account(const FluidState<Dim, Real>& state, Pool& pool);

/// Kinetic energy of the particles.
template <int Dim, class Real> [[nodiscard]] double kinetic_energy(const FluidState<Dim, Real>& state, Pool& pool);

/// Kinetic energy that the grid gained from u_old to u, on the mass of the particles that take part in the transfer:
/// sum_p m_p sum_i w_ip (u_i^2 - u_old_i^2) / 2. `room` is overwritten.
template <int Dim, class Real>
[[nodiscard]] double grid_gain(const FluidState<Dim, Real>& state, const Components<Dim, Real>& u,
                               Components<Dim, Real>& room, Pool& pool);

} // namespace flipbook
