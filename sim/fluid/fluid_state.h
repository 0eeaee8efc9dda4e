// SPDX-License-Identifier: MIT
// All that an incompressible run consists of, for those who look at it: channels, lattices, the ledger, tests.
#pragma once

#include "sim/core/order.h"
#include "sim/fluid/cells.h"
#include "sim/fluid/pcg.h"
#include "sim/fluid/solids.h"
#include "sim/fluid/walls.h"
#include "sim/scene/scene.h"

namespace flipbook {

/// The grid that the settings ask for.
template <int Dim> [[nodiscard]] Grid<Dim> grid_of(const Settings& settings) {
  Grid<Dim> grid;
  std::copy_n(settings.grid.cells.begin(), Dim, grid.cells.data());
  grid.dx = settings.dx();
  return grid;
}

template <int Dim, class Real> struct FluidState {
  FluidState(const Settings& given, const Grid<Dim>& g, Particles<Dim, Real> seeded, std::vector<Obstacle> obstacles)
      : settings(given), grid(g), walls(g, given.walls), solids(g, std::move(obstacles), domain_of(given)),
        particles(std::move(seeded)) {
    for (Components<Dim, Real>* field : {&m, &u, &u_old}) field->resize(grid);
    phi.resize(static_cast<std::size_t>(grid.size()));
    p.resize(static_cast<std::size_t>(grid.size()));
  }

  Settings settings;
  Grid<Dim> grid;
  Walls<Dim, Real> walls;
  Solids<Dim, Real> solids;
  Particles<Dim, Real> particles;
  CellOrder<Dim> order;

  Components<Dim, Real> m;               ///< mass that the particles gave to each face (kg)
  Components<Dim, Real> u, u_old;        ///< grid velocity now, and as the last P2G left it; pads filled
  Field<Real> phi;                       ///< level set at cell centres (m)
  Cells<Dim, Real> cells;                ///< where liquid is
  Field<double> p;                       ///< pressure at cell centres (Pa)
  SolveReport solve{};                   ///< of the last pressure solve
  std::vector<std::uint8_t> ballistic{}; ///< of each particle: flies on its own

  double time = 0, last_dt = 0;
  std::uint64_t steps = 0;
};

} // namespace flipbook
