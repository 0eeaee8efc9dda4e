// SPDX-License-Identifier: MIT
// All that a run of round trips consists of. Nothing moves, so the particles stay in the cell order of the start.
#pragma once

#include "sim/core/order.h"
#include "sim/fluid/walls.h"
#include "sim/scene/settings.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flipbook {

template <int Dim, class Real> struct TripState {
  Settings settings;
  Grid<Dim> grid;
  Walls<Dim, Real> walls; ///< knows the periodic axes; it has no say elsewhere
  Particles<Dim, Real> particles;
  CellOrder<Dim> order;
  std::array<std::vector<Real>, Dim> v_start; ///< the particles' velocities at the start

  Components<Dim, Real> m, u; ///< mass and velocity on the grid, as the last P2G left them

  double time = 0;
  std::uint64_t steps = 0;

  [[nodiscard]] KernelName kernel() const { return settings.transfer.kernel; }
  [[nodiscard]] Layout layout() const { return settings.grid.layout; }
  [[nodiscard]] std::array<bool, static_cast<std::size_t>(Dim)> periodic() const {
    std::array<bool, static_cast<std::size_t>(Dim)> axes;
    for (int a = 0; a < Dim; ++a) axes[static_cast<std::size_t>(a)] = walls.periodic(a);
    return axes;
  }
  [[nodiscard]] bool any_periodic() const {
    for (int a = 0; a < Dim; ++a)
      if (walls.periodic(a)) return true;
    return false;
  }
  /// The point about which angular momentum is taken, from the lower corner of the domain.
  [[nodiscard]] Vec<Dim, double> origin() const {
    Vec<Dim, double> o = grid.size_m() / 2;
    for (int d = 0; d < Dim; ++d) o[d] += settings.ledger.origin[static_cast<std::size_t>(d)];
    return o;
  }
};

/// P2G of these particles, sums in the pads of periodic axes folded in, and u = (m u) / m.
template <int Dim, class Real>
void particles_to_grid(const TripState<Dim, Real>& state, const Particles<Dim, Real>& particles,
                       Components<Dim, Real>& m, Components<Dim, Real>& u, Pool& pool);

/// |v_p - u(x_p)| in m/s, u being what P2G would leave on the grid now: what a particle's velocity holds that the grid
/// cannot see.
template <int Dim, class Real> [[nodiscard]] std::vector<float> unseen(const TripState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
