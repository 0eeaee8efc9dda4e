// SPDX-License-Identifier: MIT
#include "sim/scene/settings.h"

#include "sim/scene/preset.h"
#include "sim/scene/solver_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipbook {
namespace {

constexpr Option precisions[] = {{"single", "32-bit numbers: twice as fast"}, {"double", "64-bit numbers"}};
constexpr Option presets[] = {{"none", "Flipbook's own method"},
                              {"tutorial", "The fluid notes' program, step for step; PIC and FLIP, double, 3D"}};
constexpr Option patterns[] = {{"regular", "At the centres of the sub-cells"},
                               {"jittered", "One at a random place in each sub-cell"}};
constexpr Option locksteps[] = {{"shared", "One dt for all variants, the smallest that any of them needs"},
                                {"own", "Each variant takes its own dt; they meet at the frames"}};
constexpr Option splittings[] = {{"lie", "Transfer, forces, projection, advection one after the other; first order"},
                                 {"midpoint", "Forces and projection at the middle of the step; second order"},
                                 {"reflection", "Advection, reflection about the projected velocity, advection"}};
constexpr Option methods[] = {{"fluid", "Incompressible flow with a free surface"},
                              {"transfer", "Nothing but the transfers: particles to grid and back, over and over"},
                              {"mpm", "Solids and granular matter by the material point method"}};
constexpr Option forces_of_stress[] = {{"gradient", "Through the gradient of the kernel"},
                                       {"mls", "Through the affine part of a moving least squares fit: MLS-MPM"}};
constexpr Option layouts[] = {{"mac", "Each component at the middles of the faces across its axis"},
                              {"nodes", "All components at the corners of the cells"}};
constexpr Option ledger_rows[] = {{"frame", "One account a frame"}, {"step", "One account a step"}};
constexpr Option advections[] = {
    {"rk1", "Forward Euler"}, {"rk2", "Midpoint rule"}, {"rk3", "Ralston's third-order rule"}};
constexpr Option wall_kinds[] = {
    {"free_slip", "Nothing passes; sliding along is free"},
    {"no_slip", "Nothing passes; the fluid at the wall stands still"},
    {"periodic", "What leaves on one side enters on the other"},
    {"separating", "Nothing passes, what moves away is let go, what is pressed on it rubs"}};
constexpr Option surfaces[] = {{"ghost", "Zero pressure where the level set is zero: second order"},
                               {"voxel", "Zero pressure at the centres of air cells: first order"},
                               {"full", "No air: every cell is fluid"}};
constexpr Option solvers[] = {
    {"multigrid", "Conjugate gradients with multigrid: as many iterations for fine grids as for coarse ones"},
    {"mic", "Conjugate gradients with modified incomplete Cholesky, MIC(0)"},
    {"cg", "Conjugate gradients, scaled by the diagonal"},
    {"eigen", "Conjugate gradients with incomplete Cholesky, both Eigen's: to compare with; slow"}};

constexpr double most_cells = 1 << 27; // a field in single precision then takes half a GiB

} // namespace

void GridSettings::describe(ParameterVisitor& v) {
  v.integers({.name = "cells",
              .help = "Number of cells along each axis; cells are cubic, so it follows the size",
              .min = 1,
              .max = 16384,
              .level = Level::teach,
              .effect = Effect::restart},
             cells);
  v.reals({.name = "size",
           .help = "Extent of the domain along each axis",
           .unit = "m",
           .min = 1e-6,
           .max = 1e6,
           .effect = Effect::restart},
          size);
  v.reals({.name = "origin",
           .help = "World coordinates of the lower corner of the domain, in which files of particles and meshes are",
           .unit = "m",
           .min = -1e6,
           .max = 1e6,
           .effect = Effect::restart},
          origin);
  v.choice({.name = "layout",
            .help = "Where the velocity of the grid is sampled; a fluid is on MAC faces",
            .effect = Effect::restart},
           layout, layouts);
}

void SeedingSettings::describe(ParameterVisitor& v) {
  v.choice({.name = "pattern", .help = "Where in its sub-cell a particle starts", .effect = Effect::restart}, pattern,
           patterns);
  v.integer({.name = "per_axis",
             .help = "Particles along each axis of a cell",
             .min = 1,
             .max = 8,
             .effect = Effect::restart},
            per_axis);
  v.integer(
      {.name = "seed", .help = "Chooses the random places of jittered particles", .min = 0, .effect = Effect::restart},
      seed);
}

void TimeSettings::describe(ParameterVisitor& v) {
  v.real({.name = "cfl",
          .help = "Cells that the fastest flow may cross in one step",
          .min = 0.01,
          .max = 5,
          .level = Level::teach},
         cfl);
  v.real({.name = "dt", .help = "Longest step; 0: only time.cfl bounds it", .unit = "s", .min = 0, .max = 1000}, dt);
  v.choice(
      {.name = "lockstep", .help = "Whether the variants of a comparison share one step", .effect = Effect::restart},
      lockstep, locksteps);
  v.choice({.name = "splitting", .help = "How a step combines advection and projection"}, splitting, splittings);
  v.choice({.name = "advection", .help = "How a particle follows the velocity of the grid"}, advection, advections);
  v.real({.name = "scale",
          .help = "Simulated seconds in one second of video; below 1: slow motion",
          .min = 0.001,
          .max = 1000,
          .effect = Effect::restart},
         scale);
}

void WallSettings::describe(ParameterVisitor& v) {
  v.choice({.name = "x", .help = "The two walls across x", .effect = Effect::restart}, axis[0], wall_kinds);
  v.choice({.name = "y", .help = "The two walls across y", .effect = Effect::restart}, axis[1], wall_kinds);
  v.choice({.name = "z", .help = "The two walls across z; only in 3D", .effect = Effect::restart}, axis[2], wall_kinds);
  v.real({.name = "friction",
          .help = "Coulomb's coefficient of friction on walls that are \"separating\"",
          .min = 0,
          .max = 10,
          .level = Level::teach,
          .applies = std::find(axis.begin(), axis.end(), Wall::separating) != axis.end()},
         friction);
}

void FluidSettings::describe(ParameterVisitor& v) {
  v.real({.name = "density",
          .help = "Density of the fluid",
          .unit = "kg/m^3",
          .min = 1e-6,
          .max = 1e6,
          .effect = Effect::restart},
         density);
  v.reals({.name = "gravity",
           .help = "Acceleration of all fluid; y is up",
           .unit = "m/s^2",
           .min = -1e4,
           .max = 1e4,
           .level = Level::teach},
          gravity);
  v.choice({.name = "surface", .help = "Where the pressure of the air begins"}, surface, surfaces);
  v.real({.name = "spacing",
          .help = "Strength of the correction that keeps particles apart; 0: off",
          .min = 0,
          .max = 1,
          .level = Level::teach},
         spacing);
}

std::array<double, 3> FluidSettings::up(int dim) const {
  std::size_t axis = 1;
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}})
    if (static_cast<int>(a) < dim && std::abs(gravity[a]) > std::abs(gravity[axis])) axis = a;
  std::array<double, 3> direction{0, 0, 0};
  direction[axis] = gravity[axis] > 0 ? -1 : 1;
  return direction;
}

void PressureSettings::describe(ParameterVisitor& v) {
  v.choice({.name = "solver", .help = "How the pressure equation is solved"}, solver, solvers);
  v.real({.name = "tolerance",
          .help = "The solve ends when the residual's norm has fallen by this factor",
          .min = 1e-14,
          .max = 0.1},
         tolerance);
  v.integer({.name = "max_iterations", .help = "The solve ends after this many iterations", .min = 1, .max = 1e6},
            max_iterations);
}

void MpmSettings::describe(ParameterVisitor& v) {
  v.choice({.name = "forces", .help = "What the stress of a particle acts on the grid through"}, forces,
           forces_of_stress);
}

void LedgerSettings::describe(ParameterVisitor& v) {
  v.flag({.name = "on",
          .help = "Measure momentum, angular momentum and energy at every stage of a step",
          .effect = Effect::restart},
         on);
  v.choice({.name = "rows", .help = "How often a row goes to the ledger's file", .effect = Effect::restart}, rows,
           ledger_rows);
  v.reals({.name = "origin",
           .help = "Point about which angular momentum is taken, from the centre of the domain",
           .unit = "m",
           .min = -1e6,
           .max = 1e6,
           .effect = Effect::restart},
          origin);
}

void Settings::describe(ParameterVisitor& all) {
  PresetFilter presets_apart(all, *this);
  SolverFilter v(presets_apart, *this);
  v.integer({.name = "dim", .help = "2: a plane, 3: space", .min = 2, .max = 3, .effect = Effect::restart}, dim);
  v.choice({.name = "solver", .help = "What a step consists of", .effect = Effect::restart}, solver, methods);
  v.choice({.name = "preset", .help = "Whose algorithm runs", .effect = Effect::restart}, preset, presets);
  v.choice({.name = "precision", .help = "Numbers that the solver computes with", .effect = Effect::restart}, precision,
           precisions);
  v.group("grid", [&] { grid.describe(v); });
  v.group("seeding", [&] { seeding.describe(v); });
  v.group("transfer", [&] { transfer.describe(v); });
  v.group("time", [&] { time.describe(v); });
  v.group("walls", [&] { walls.describe(v); });
  v.group("fluid", [&] { fluid.describe(v); });
  v.group("pressure", [&] { pressure.describe(v); });
  v.group("material", [&] { material.describe(v); });
  v.group("mpm", [&] { mpm.describe(v); });
  v.group("ledger", [&] { ledger.describe(v); });
}

double Settings::dx() const {
  if (const Conflict c = conflict(); c.path == "grid.cells") throw UserError(c.message);
  return grid.size[0] / grid.cells[0];
}

Settings::Conflict Settings::conflict() const {
  constexpr double rounding = 1e-9; // sizes such as 1.2 and 0.3 have no exact quotient
  constexpr std::string_view axes = "xyz";
  const double dx0 = grid.size[0] / grid.cells[0];
  double all = 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
    const double dxa = grid.size[a] / grid.cells[a];
    all *= grid.cells[a];
    if (std::abs(dxa - dx0) > rounding * dx0)
      return {"grid.cells", "cells must be cubic: size / cells is " + to_toml(dx0) + " m along x but " + to_toml(dxa) +
                                " m along " + axes[a]};
    if (walls.axis[a] == Wall::periodic && grid.cells[a] % 2 != 0)
      return {"grid.cells", std::string("a periodic axis needs an even number of cells, not ") +
                                std::to_string(grid.cells[a]) + " along " + axes[a]};
  }
  if (all > most_cells)
    return {"grid.cells", "the grid has " + to_toml(all) + " cells; at most " + to_toml(most_cells) + " are supported"};
  if (precision == Precision::single && pressure.tolerance < 1e-7)
    return {"pressure.tolerance", "a pressure.tolerance of " + to_toml(pressure.tolerance) +
                                      " cannot be reached in single precision; set precision = \"double\""};
  if (Conflict c = solver_conflict(*this); !c.path.empty()) return c;
  return preset_conflict(*this);
}

} // namespace flipbook
