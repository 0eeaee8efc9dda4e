// SPDX-License-Identifier: MIT
// Every parameter of one simulation, as plain data. Each part describes itself; Settings::describe lists the parts.
#pragma once

#include "sim/core/lattice.h"
#include "sim/frame/parameters.h"
#include "sim/materials/material_settings.h"
#include "sim/transfer/settings.h"

#include <array>
#include <string>

namespace flipbook {

enum class Precision { single, double_ };
enum class Wall { free_slip, no_slip, periodic, separating };
enum class Surface {
  ghost,
  voxel,
  full
}; ///< second order in the level set; air begins at a cell centre; no air at all
/// Conjugate gradients with a multigrid cycle, with modified incomplete Cholesky, plain (Jacobi), and those of Eigen.
enum class PressureSolver { multigrid, mic, cg, eigen };
enum class Lockstep { shared, own };
enum class Splitting { lie, midpoint, reflection };
enum class Advection { rk1, rk2, rk3 };
enum class Pattern { regular, jittered };
/// An incompressible liquid; nothing but P2G and G2P over and over; solids by the material point method.
enum class Solver { fluid, transfer, mpm };
enum class Forces { gradient, mls }; ///< what the stress of a particle acts through: grad w_ip, or w_ip D_p^-1 r
enum class LedgerRows { frame, step };
enum class Preset { none, tutorial }; ///< whose algorithm runs: ours, or step for step that of the fluid notes

struct GridSettings {
  std::array<int, 3> cells{64, 64, 64};
  std::array<double, 3> size{1, 1, 1};   ///< metres
  std::array<double, 3> origin{0, 0, 0}; ///< world coordinates of the domain's lower corner (m); only files know them
  Layout layout = Layout::mac;           ///< of the velocity; a fluid is on MAC faces
  void describe(ParameterVisitor& v);
};

struct SeedingSettings {
  Pattern pattern = Pattern::jittered;
  int per_axis = 2; ///< particles per cell and axis
  int seed = 1;
  void describe(ParameterVisitor& v);
};

struct TimeSettings {
  double cfl = 0.5;
  double dt = 0; ///< upper bound in seconds; 0: only the CFL condition bounds a step
  Lockstep lockstep = Lockstep::shared;
  Splitting splitting = Splitting::lie;
  Advection advection = Advection::rk3;
  double scale = 1; ///< simulated seconds per second of video
  void describe(ParameterVisitor& v);
};

struct WallSettings {
  std::array<Wall, 3> axis{Wall::free_slip, Wall::free_slip, Wall::free_slip}; ///< walls.x walls.y walls.z, both sides
  double friction = 0; ///< Coulomb's coefficient on separating walls
  void describe(ParameterVisitor& v);
};

struct FluidSettings {
  double density = 1000;                      ///< kg/m^3 (kg/m^2 in 2D)
  std::array<double, 3> gravity{0, -9.81, 0}; ///< m/s^2
  Surface surface = Surface::ghost;
  double spacing = 0; ///< strength of the particle-spacing correction in [0, 1]; 0: off
  void describe(ParameterVisitor& v);
  /// The axis that points against gravity the most, with its sign; y without gravity.
  [[nodiscard]] std::array<double, 3> up(int dim) const;
};

struct PressureSettings {
  PressureSolver solver = PressureSolver::multigrid;
  double tolerance = 1e-6; ///< relative residual norm
  int max_iterations = 2000;
  void describe(ParameterVisitor& v);
};

struct MpmSettings {
  Forces forces = Forces::gradient;
  void describe(ParameterVisitor& v);
};

struct LedgerSettings {
  bool on = true;
  LedgerRows rows = LedgerRows::frame;   ///< of LedgerTable::accounts
  std::array<double, 3> origin{0, 0, 0}; ///< about which angular momentum is taken; relative to the domain centre
  void describe(ParameterVisitor& v);
};

struct Settings {
  int dim = 2;
  Solver solver = Solver::fluid;
  Preset preset = Preset::none;
  Precision precision = Precision::single;
  GridSettings grid;
  SeedingSettings seeding;
  TransferSettings transfer;
  TimeSettings time;
  WallSettings walls;
  FluidSettings fluid;
  PressureSettings pressure;
  MaterialSettings material; ///< of bodies that have none of their own
  MpmSettings mpm;
  LedgerSettings ledger;
  void describe(ParameterVisitor& v);

  /// Cell size; throws UserError where size / cells differs between the axes in use (cells are cubic).
  [[nodiscard]] double dx() const;

  /// Two parameters that do not go together, each fine by itself.
  struct Conflict {
    std::string path, message; ///< the parameter to point at; empty: no conflict
  };
  [[nodiscard]] Conflict conflict() const;
};

} // namespace flipbook
