// SPDX-License-Identifier: MIT
// The particles that a scene starts with. First the rows of its files, x = x_world - grid.origin, with ids that count
// them from 0. Then those of its bodies: per_axis^Dim in each cell, one in each sub-cell, kept where they lie in a
// body. The place in the sub-cell is its centre, or jitter = f(seed, cell, k), so that it depends neither on the
// precision nor on what else is in the scene. Their ids go on in the order of the cells (x fastest), then of the
// sub-cells.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/particles.h"
#include "sim/scene/scene.h"

namespace flipbook {

/// Where the k-th particle of a cell starts, from the lower corner of the domain (m); k counts the sub-cells, x
/// fastest.
template <int Dim>
[[nodiscard]] Point seed_place(const SeedingSettings& seeding, const Grid<Dim>& grid, const Index<Dim>& cell,
                               std::uint64_t k);

/// Each has the mass density dx^Dim / per_axis^Dim, from a file or not; where rows and bodies overlap there is fluid
/// twice. Throws UserError where the particles are none or too many, and where check_rows() does.
template <int Dim, class Real>
[[nodiscard]] Particles<Dim, Real> seed_particles(const Scene& scene, const Grid<Dim>& grid);

/// The same, with the body that each of them belongs to, an index into scene.fluid; -1: a file's row.
template <int Dim, class Real> struct Seeded {
  Particles<Dim, Real> particles;
  std::vector<int> body;
};
template <int Dim, class Real> [[nodiscard]] Seeded<Dim, Real> seed_bodies(const Scene& scene, const Grid<Dim>& grid);

} // namespace flipbook
