// SPDX-License-Identifier: MIT
#include "sim/simulation.h"

#include "sim/fluid/fluid_solver.h"
#include "sim/mpm/mpm_solver.h"
#include "sim/scene/preset.h"
#include "sim/scene/scene.h"
#include "sim/scene/seeding.h"
#include "sim/transfer_only/round_trips.h"
#include "sim/tutorial/notes_input.h"
#include "sim/tutorial/own_method.h"
#include "sim/tutorial/tutorial_solver.h"

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
  return std::make_unique<FluidSolver<Dim, Real>>(scene.settings, seed_particles<Dim, Real>(scene, grid), pool,
                                                  scene.obstacles);
}

template <int Dim> std::unique_ptr<Simulation> make_fluid(const Scene& scene, Pool& pool) {
  return scene.settings.precision == Precision::single ? make_fluid<Dim, float>(scene, pool)
                                                       : make_fluid<Dim, double>(scene, pool);
}

/// `solver = "transfer"`
template <int Dim> std::unique_ptr<Simulation> make_round_trips(const Scene& scene, Pool& pool) {
  if (scene.settings.precision == Precision::single) return std::make_unique<RoundTrips<Dim, float>>(scene, pool);
  return std::make_unique<RoundTrips<Dim, double>>(scene, pool);
}

/// `solver = "mpm"`
template <int Dim> std::unique_ptr<Simulation> make_solids(const Scene& scene, Pool& pool) {
  if (scene.settings.precision == Precision::single) return std::make_unique<MpmSolver<Dim, float>>(scene, pool);
  return std::make_unique<MpmSolver<Dim, double>>(scene, pool);
}

/// `preset = "tutorial"`: the fluid notes' algorithm, or ours on their input for a scheme that they do not have.
std::unique_ptr<Simulation> make_tutorial(const Scene& scene, Pool& pool) {
  if (runs_notes(scene.settings)) return std::make_unique<TutorialSolver>(scene, pool);
  return std::make_unique<OwnMethod>(scene.settings, make_fluid<3, double>(without_solid_layer(scene), pool));
}

} // namespace

void check_scene(const Scene& scene) {
  check(scene.settings);
  if (scene.settings.solver == Solver::transfer && !scene.obstacles.empty())
    throw UserError("solver = \"transfer\" has no obstacles, and the scene \"" + scene.name + "\" has some");
  if (scene.settings.solver == Solver::fluid)
    for (const Obstacle& o : scene.obstacles)
      if (o.separating)
        throw UserError("contact = \"separating\" is for solver = \"mpm\"; a fluid leaves any obstacle where its "
                        "surface does");
  if (scene.settings.preset != Preset::tutorial) return;
  refuse_what_the_notes_lack(scene);
  check_notes_particles(scene);
}

std::unique_ptr<Simulation> make_simulation(const Scene& scene, Pool& pool) {
  check_scene(scene);
  if (scene.settings.preset == Preset::tutorial) return make_tutorial(scene, pool);
  if (scene.settings.solver == Solver::transfer)
    return scene.settings.dim == 2 ? make_round_trips<2>(scene, pool) : make_round_trips<3>(scene, pool);
  if (scene.settings.solver == Solver::mpm)
    return scene.settings.dim == 2 ? make_solids<2>(scene, pool) : make_solids<3>(scene, pool);
  return scene.settings.dim == 2 ? make_fluid<2>(scene, pool) : make_fluid<3>(scene, pool);
}

} // namespace flipbook
