// SPDX-License-Identifier: MIT
#include "sim/fluid/liquid.h"

#include "sim/fluid/fluid_state.h"
#include "sim/fluid/level_set.h"

namespace flipbook {

template <int Dim, class Real>
void find_liquid(const Settings& settings, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                 const Solids<Dim, Real>& solids, const Particles<Dim, Real>& particles, const CellOrder<Dim>& order,
                 Field<Real>& phi, Cells<Dim, Real>& cells, Pool& pool) {
  level_set(grid, walls, particles, order, particle_radius<Dim>(grid.dx, settings.seeding.per_axis), phi, pool);
  solids.extend(walls, phi);
  const Surface surface = settings.fluid.surface;
  cells.classify(surface, grid, walls, order, phi, pool,
                 surface == Surface::voxel ? solids.wet(walls, order) : std::vector<std::size_t>{});
}

template <int Dim, class Real> Liquid<Dim, Real> liquid_now(const FluidState<Dim, Real>& s, Pool& pool) {
  Liquid<Dim, Real> liquid;
  Particles<Dim, Real> sorted = s.particles;
  CellOrder<Dim> order;
  sort_by_cell(sorted, s.grid, order, pool);
  find_liquid(s.settings, s.grid, s.walls, s.solids, sorted, order, liquid.phi, liquid.cells, pool);
  return liquid;
}

#define FLIPBOOK_LIQUID(Dim, Real)                                                                                     \
  template void find_liquid(const Settings&, const Grid<Dim>&, const Walls<Dim, Real>&, const Solids<Dim, Real>&,      \
                            const Particles<Dim, Real>&, const CellOrder<Dim>&, Field<Real>&, Cells<Dim, Real>&,       \
                            Pool&);                                                                                    \
  template Liquid<Dim, Real> liquid_now(const FluidState<Dim, Real>&, Pool&);
FLIPBOOK_LIQUID(2, float)
FLIPBOOK_LIQUID(2, double)
FLIPBOOK_LIQUID(3, float)
FLIPBOOK_LIQUID(3, double)
#undef FLIPBOOK_LIQUID

} // namespace flipbook
