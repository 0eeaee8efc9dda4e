// SPDX-License-Identifier: MIT
// All that a run of the fluid notes' algorithm consists of.
#pragma once

#include "sim/tutorial/notes_grid.h"

#include <cstdint>
#include <vector>

namespace flipbook {

using Faces = std::array<std::vector<double>, 3>; ///< u, v, w on the faces across x, y, z

enum class CellKind : std::uint8_t { empty, fluid, solid };

struct NotesState {
  NotesState(const Settings& given, std::vector<Point3> positions, std::vector<Point3> velocities)
      : settings(given), grid(given.grid), x(std::move(positions)), v(std::move(velocities)) {
    for (std::size_t c = 0; c < 3; ++c)
      for (Faces* f : {&u, &u_old, &weight}) (*f)[c].resize(grid.size(c));
    cells.resize(grid.size(3));
    p.resize(grid.size(3));
  }

  Settings settings;
  NotesGrid grid;
  std::vector<Point3> x, v; ///< of each particle, in the order of the input: world coordinates (m), m/s

  Faces u, u_old;              ///< now, and as the last splat left it
  Faces weight;                ///< sum of the weights that each face got
  std::vector<CellKind> cells; ///< by whether a particle is there
  std::vector<double> p;       ///< pressure in the notes' unit, m/s: pascals are density h / dt times it

  /// Kinetic energy that the transfers have lost so far (J), as sim/fluid/energy.h defines it.
  double transfer_loss = 0;
  std::uint64_t steps = 0;
  int iterations = 0;  ///< of the last pressure solve
  double residual = 0; ///< |r| / |r0| at its end

  [[nodiscard]] double dt() const { return settings.time.dt; }
  [[nodiscard]] double time() const { return static_cast<double>(steps) * dt(); }
  /// What a particle weighs where per_axis^3 of them fill a cell (kg). The algorithm itself knows no mass.
  [[nodiscard]] double particle_mass() const {
    const double spacing = grid.h / settings.seeding.per_axis;
    return settings.fluid.density * spacing * spacing * spacing;
  }
  [[nodiscard]] double kinetic_energy() const {
    double sum = 0;
    for (const Point3& one : v) sum += one[0] * one[0] + one[1] * one[1] + one[2] * one[2];
    return particle_mass() * sum / 2;
  }
};

} // namespace flipbook
