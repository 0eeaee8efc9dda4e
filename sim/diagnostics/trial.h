// SPDX-License-Identifier: MIT
// A small random state to try the transfers on: particles away from the walls and from the grid lines, in cell order,
// and fields for the grid. Everything is a function of the seed.
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/core/particles.h"
#include "sim/core/random.h"

#include <cmath>

namespace flipbook {

template <int Dim, class Real> struct Trial {
  Grid<Dim> grid;
  Particles<Dim, Real> particles;
  CellOrder<Dim> order;
  Vec<Dim, double> origin; ///< about which angular momentum is taken: the domain's centre
  std::uint64_t seed;

  /// Positions keep 1/20 of a cell between a particle and every plane through nodes or face centres: the linear
  /// kernel's D is singular there, so that a test close to it measures the condition of D and not the transfer.
  /// `room` cells on every side stay empty, for particles that will move.
  Trial(AffineMode mode, int count, std::uint64_t seed_, Pool& pool, int room = 0) : seed(seed_) {
    for (int d = 0; d < Dim; ++d) grid.cells[d] = 6 + d + 2 * room; // unlike edges, so that a wrong stride shows
    grid.dx = 0.1;
    origin = grid.size_m() / 2;
    particles.set_mode(mode);
    for (std::uint64_t p = 0; p < static_cast<std::uint64_t>(count); ++p) {
      Vec<Dim, Real> x, v;
      for (int d = 0; d < Dim; ++d) {
        const auto c = static_cast<std::uint64_t>(d);
        const double cell = std::floor(number(0, p, c, room, grid.cells[d] - room));
        const double half = number(1, p, c, 0, 1) < 0.5 ? 0 : 0.5;
        x[d] = static_cast<Real>(grid.dx * (cell + half + number(2, p, c, 0.05, 0.45)));
        v[d] = static_cast<Real>(number(3, p, c, -1, 1));
      }
      particles.add(x, v, static_cast<Real>(number(4, p, 0, 0.5, 2)), static_cast<std::uint32_t>(p));
      for (std::size_t c = 0; c < particles.A.size(); ++c)
        particles.A[c].back() = static_cast<Real>(number(5, p, c, -1, 1) / grid.dx);
    }
    sort_by_cell(particles, grid, order, pool);
  }

  /// Uniform in (lo, hi): number `i` of item `p` of stream `stream`.
  [[nodiscard]] double number(std::uint64_t stream, std::uint64_t p, std::uint64_t i, double lo, double hi) const {
    return lo + (hi - lo) * uniform(mix(seed) + stream, p, i);
  }

  /// Every sample, pads included, uniform in (-1, 1).
  [[nodiscard]] Components<Dim, Real> random_field(std::uint64_t stream) const {
    Components<Dim, Real> u;
    u.resize(grid);
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t k = 0; k < u[a].size(); ++k) u[a][k] = static_cast<Real>(number(100 + stream, k, a, -1, 1));
    return u;
  }

  /// u(x) = v + C (x - origin), with random v and C; C antisymmetric where `rigid`.
  [[nodiscard]] Components<Dim, Real> affine_field(Layout layout, bool rigid) const {
    Vec<Dim, double> v;
    Mat<Dim, double> C;
    for (int a = 0; a < Dim; ++a) {
      v[a] = number(6, static_cast<std::uint64_t>(a), 0, -1, 1);
      for (int b = 0; b < Dim; ++b)
        C(a, b) = number(7, static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b), -1, 1) / (4 * grid.dx);
    }
    if (rigid) C = (C - C.transpose()).eval();
    Components<Dim, Real> u;
    u.resize(grid);
    for (int a = 0; a < Dim; ++a)
      each_sample(layout, a, [&](std::size_t k, const Vec<Dim, double>& x) {
        u[static_cast<std::size_t>(a)][k] = static_cast<Real>(v[a] + C.row(a).dot(x - origin));
      });
    return u;
  }

  /// body(position in the field, place) for every sample of component a.
  template <class Body> void each_sample(Layout layout, int a, Body&& body) const {
    const Vec<Dim, double> lattice = component_origin<Dim, double>(layout, a);
    for (std::ptrdiff_t k = 0; k < grid.size(); ++k) {
      const Vec<Dim, double> i = grid.index(k).template cast<double>();
      body(static_cast<std::size_t>(k), Vec<Dim, double>(grid.dx * (i.array() - Grid<Dim>::pad + lattice.array())));
    }
  }
};

} // namespace flipbook
