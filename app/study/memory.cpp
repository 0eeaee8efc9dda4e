// SPDX-License-Identifier: MIT
#include "app/study/memory.h"

#include "sim/core/lattice.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace flipbook::app {
namespace {

/// The share of the domain that the bodies fill, looked up at evenly spread points.
double filled(const Scene& scene) {
  const Domain domain = scene.domain();
  const int dim = scene.settings.dim, n = dim == 2 ? 256 : 48, nz = dim == 2 ? 1 : n;
  if (scene.fluid.empty()) return 0;
  int inside = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Point p{(i + 0.5) / n * scene.settings.grid.size[0], (j + 0.5) / n * scene.settings.grid.size[1],
                      dim == 2 ? 0 : (k + 0.5) / n * scene.settings.grid.size[2]};
        inside += std::any_of(scene.fluid.begin(), scene.fluid.end(),
                              [&](const Body& b) { return b.shape->contains(p, domain); });
      }
  return static_cast<double>(inside) / (static_cast<double>(n) * n * nz);
}

constexpr double row_bytes_of_file = 48; // x and v, shared by all variants

/// The particles that come from files.
double rows_of(const Scene& scene) {
  double rows = 0;
  for (const ParticleSource& source : scene.particles) rows += static_cast<double>(source.rows->size());
  return rows;
}

// In 3D and single precision 161 bytes for a particle, 95 for a sample and 68 for a cell with liquid; measured for the
// dam breaks of `flipbook bench` at 64^3 and 128^3: 160, 95, 70.

/// x, v, m, the affine state and a column to sort with; id, cell, source and their copy; where it started; its
/// snapshot, and room to sort that.
double particle_bytes(int dim, double real) {
  return real * (2 * dim + 2 + dim * dim) + 4 * 4 + 12 + 1 + 4 * (2 * dim + 2) + 8 * (dim + 1);
}

/// What a particle of a solid carries besides: V0, F, memory, V0 tau; its material, also by id.
double carried_bytes(int dim, double real) {
  return real * (3 + dim * dim + dim * (dim + 1) / 2) + 2;
}

/// Of solids: m, u, u_old, f, what walls keep; the beginning of its particles.
double node_bytes(int dim, double real) {
  return real * 6 * dim + 4;
}

/// m, u, u_old, openings, distances to the surface and the solids' velocity on faces, phi; p; the beginning of its
/// particles; masks.
double sample_bytes(int dim, double real) {
  return real * (6 * dim + 1) + 8 + 4 + 1 + 2 * dim;
}

/// A row of the pressure equation and the solver's vectors, for a cell with liquid; an eighth for coarser levels.
double row_bytes(int dim, double real) {
  return (real * (dim + 1) + 4 * 5 + 8 * 3) * 9 / 8;
}

std::string gigabytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f GB", bytes < 1e10 ? 1 : 0, 1e-9 * bytes);
  return text;
}

} // namespace

Need memory_need(const Resolved& resolved) {
  Need need;
  if (!resolved.variants.empty()) need.bytes = row_bytes_of_file * rows_of(resolved.variants.front().scene);
  for (const ResolvedVariant& v : resolved.variants) {
    const Settings& s = v.scene.settings;
    const double real = s.precision == Precision::single ? 4 : 8;
    double cells = 1, samples = 1;
    for (int d = 0; d < s.dim; ++d) {
      const int n = s.grid.cells[static_cast<std::size_t>(d)];
      cells *= n;
      samples *= n + 2 * Grid<2>::pad + 1;
    }
    const double in_cell = std::pow(s.seeding.per_axis, s.dim), rows = rows_of(v.scene);
    const double particles = cells * filled(v.scene) * in_cell + rows;
    const double wet = std::min(cells, particles / in_cell); // rows fill cells as seeded particles do
    need.cells += cells;
    need.particles += particles;
    need.bytes += particles * particle_bytes(s.dim, real);
    if (s.solver == Solver::mpm)
      need.bytes += particles * carried_bytes(s.dim, real) + samples * node_bytes(s.dim, real);
    else
      need.bytes += samples * sample_bytes(s.dim, real) + wet * row_bytes(s.dim, real);
  }
  return need;
}

void refuse_too_large(const Resolved& resolved, double available) {
  const Need need = memory_need(resolved);
  if (need.bytes <= available) return;
  char counts[96];
  std::snprintf(counts, sizeof counts, "%.3g million cells and %.3g million particles", 1e-6 * need.cells,
                1e-6 * need.particles);
  throw UserError("the run needs about " + gigabytes(need.bytes) + " of memory (" + counts +
                  " in all panes); this machine has " + gigabytes(available) + ": choose fewer cells");
}

void refuse_too_large(const Resolved& resolved) {
  const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (available > 0) refuse_too_large(resolved, available);
}

std::vector<std::string> long_run(const Resolved& resolved) {
  constexpr double many = 1e7;
  const double particles = memory_need(resolved).particles;
  if (particles <= many) return {};
  const bool space = resolved.variants.front().scene.settings.dim == 3;
  char text[160];
  std::snprintf(text, sizeof text,
                "%.2g million particles in all panes will take long; half as many cells along x are %d times fewer",
                1e-6 * particles, space ? 8 : 4);
  return {text};
}

} // namespace flipbook::app
