// SPDX-License-Identifier: MIT
// What every solver on our grids publishes alike: where the domain is, its particles, lattices of samples, a number for
// each particle.
#pragma once

#include "sim/core/parallel.h"
#include "sim/core/particles.h"
#include "sim/fluid/box.h"
#include "sim/fluid/walls.h"
#include "sim/frame/particle_order.h"
#include "sim/frame/snapshot.h"
#include "sim/transfer/interpolate.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flipbook {

/// value(particle) for every particle.
template <class Value>
[[nodiscard]] std::vector<float> for_each_particle(std::size_t count, Pool& pool, Value&& value) {
  std::vector<float> values(count);
  pool.ranges(static_cast<std::int64_t>(count), 4096, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      values[p] = static_cast<float>(value(p));
  });
  return values;
}

/// |v_p - u(x_p)| of every particle (m/s).
template <int Dim, class Real>
[[nodiscard]] std::vector<float> distance_from(const Components<Dim, Real>& velocity, KernelName kernel, Layout layout,
                                               const Grid<Dim>& grid, const Particles<Dim, Real>& particles,
                                               Pool& pool) {
  return with_kernel(kernel, [&](auto k) {
    const Interpolator<decltype(k), Dim, Real> u(layout, grid, velocity);
    return for_each_particle(particles.size(), pool,
                             [&](std::size_t p) { return (particles.velocity(p) - u(particles.position(p))).norm(); });
  });
}

/// 0 of nothing.
[[nodiscard]] inline double root_mean_square(const std::vector<float>& values) {
  double sum = 0;
  for (const float x : values) sum += static_cast<double>(x) * static_cast<double>(x);
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, values.size())));
}

/// The samples of a box as a lattice; `origin` in cells.
template <int Dim, class Real>
[[nodiscard]] LatticeData lattice(const Grid<Dim>& grid, const Box<Dim>& box, std::string name,
                                  const Vec<Dim, double>& origin, const Field<Real>& f, Pool& pool) {
  LatticeData data;
  data.name = std::move(name);
  data.dx = static_cast<float>(grid.dx);
  for (int d = 0; d < Dim; ++d) {
    data.n[static_cast<std::size_t>(d)] = box.hi[d] - box.lo[d];
    data.origin[static_cast<std::size_t>(d)] = static_cast<float>(grid.dx * origin[d]);
  }
  std::array<std::size_t, Dim> stride;
  std::size_t count = 1;
  for (std::size_t d = 0; d < Dim; ++d) stride[d] = std::exchange(count, count * static_cast<std::size_t>(data.n[d]));
  data.values.resize(count);
  each_in(grid, box, pool, [&](const Index<Dim>& i, std::size_t at) {
    std::size_t to = 0;
    for (std::size_t d = 0; d < Dim; ++d)
      to += stride[d] * static_cast<std::size_t>(i[static_cast<int>(d)] - box.lo[static_cast<int>(d)]);
    data.values[to] = static_cast<float>(f[at]);
  });
  return data;
}

template <int Dim, class Real>
void publish_domain(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, int particles_per_axis, Snapshot& s) {
  s.dim = Dim;
  s.dx = grid.dx;
  s.particle_spacing = grid.dx / particles_per_axis;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    s.hi[axis] = grid.size_m()[a];
    s.cells[axis] = grid.cells[a];
    s.periodic[axis] = walls.periodic(a);
  }
}

/// In the order in which the particles lie.
template <int Dim, class Real> void publish_particles(const Particles<Dim, Real>& particles, Snapshot& s, Pool& pool) {
  s.id = particles.id;
  s.x.resize(Dim * particles.size());
  s.v.resize(Dim * particles.size());
  pool.ranges(static_cast<std::int64_t>(particles.size()), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      for (std::size_t d = 0; d < Dim; ++d) {
        s.x[Dim * p + d] = static_cast<float>(particles.x[d][p]);
        s.v[Dim * p + d] = static_cast<float>(particles.v[d][p]);
      }
  });
}

/// sort_particles with the threads of a pool.
inline void sort_particles(Snapshot& s, Pool& pool) {
  sort_particles(s, [&](std::size_t count, const PieceBody& body) {
    pool.ranges(static_cast<std::int64_t>(count), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
      body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
    });
  });
}

} // namespace flipbook
