// SPDX-License-Identifier: MIT
#include "sim/fluid/fluid_still.h"

#include "sim/fluid/pressure_system.h"

namespace flipbook {

template <int Dim, class Real>
StageStill fluid_still(const StillOf& of, const FluidState<Dim, Real>& s, const Components<Dim, Real>& u) {
  StageStill still = still_of_particles(of, s.grid, s.particles, s.ballistic);
  add_velocity(still, s.grid, Layout::mac, s.m, u);
  const Box<Dim> cells = cells_of(s.grid);
  const Vec<Dim, double> centre = Vec<Dim, double>::Constant(0.5);
  add_samples(still, s.grid, cells, "liquid", centre, [&](std::size_t at) { return s.cells.fluid[at]; });
  add_samples(still, s.grid, cells, "p", centre, [&](std::size_t at) { return s.p[at]; });
  add_samples(still, s.grid, cells, "divergence", centre,
              [&](std::size_t at) { return s.cells.fluid[at] ? divergence(s.grid, s.walls, u, at) : Real(0); });
  return still;
}

template StageStill fluid_still(const StillOf&, const FluidState<2, float>&, const Components<2, float>&);
template StageStill fluid_still(const StillOf&, const FluidState<2, double>&, const Components<2, double>&);
template StageStill fluid_still(const StillOf&, const FluidState<3, float>&, const Components<3, float>&);
template StageStill fluid_still(const StillOf&, const FluidState<3, double>&, const Components<3, double>&);

} // namespace flipbook
