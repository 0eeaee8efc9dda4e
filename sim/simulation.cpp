// SPDX-License-Identifier: MIT
#include "sim/simulation.h"

#include "sim/fluid/fluid_solver.h"
#include "sim/scene/scene.h"
#include "sim/scene/seeding.h"

namespace flipbook {
namespace {

/// Fewer, and the pads of the two sides would overlap.
constexpr int fewest_periodic_cells = 4;

void check(const Settings& s) {
  if (s.dim != 2 && s.dim != 3) throw UserError("dim must be 2 or 3");
  if (const auto conflict = s.conflict(); !conflict.message.empty()) throw UserError(conflict.message);
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a)
    if (s.walls.axis[a] == Wall::periodic && s.grid.cells[a] < fewest_periodic_cells)
      throw UserError("a periodic axis needs at least " + std::to_string(fewest_periodic_cells) + " cells");
}

template <int Dim, class Real> std::unique_ptr<Simulation> make_fluid(const Scene& scene, Pool& pool) {
  const Grid<Dim> grid = grid_of<Dim>(scene.settings);
  return std::make_unique<FluidSolver<Dim, Real>>(scene.settings, seed_particles<Dim, Real>(scene, grid), pool);
}

template <int Dim> std::unique_ptr<Simulation> make_fluid(const Scene& scene, Pool& pool) {
  return scene.settings.precision == Precision::single ? make_fluid<Dim, float>(scene, pool)
                                                       : make_fluid<Dim, double>(scene, pool);
}

} // namespace

std::unique_ptr<Simulation> make_simulation(const Scene& scene, Pool& pool) {
  check(scene.settings);
  return scene.settings.dim == 2 ? make_fluid<2>(scene, pool) : make_fluid<3>(scene, pool);
}

} // namespace flipbook
