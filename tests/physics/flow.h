// SPDX-License-Identifier: MIT
// Small flows for tests: settings with a box of cubic cells, particles by a condition on their place, and a solver with
// its pool.
#pragma once

#include "sim/core/random.h"
#include "sim/fluid/fluid_solver.h"

#include <cmath>
#include <numbers>

namespace flipbook::test {

inline const char* const scheme_names[] = {"pic", "flip", "rpic", "apic", "aflip", "asflip", "polypic", "xpic"};
inline const char* const splitting_names[] = {"lie", "midpoint", "reflection"}; // by Splitting
enum SchemeIndex { pic, flip, rpic, apic, aflip, asflip, polypic, xpic };

/// The domain [0, cells dx] with free-slip walls, double precision and a tight pressure solve.
inline Settings box(std::array<int, 3> cells, double dx, int dim = 2) {
  Settings s;
  s.dim = dim;
  s.precision = Precision::double_;
  s.grid.cells = cells;
  for (std::size_t d = 0; d < 3; ++d) s.grid.size[d] = cells[d] * dx;
  s.seeding.pattern = Pattern::regular;
  s.pressure.tolerance = 1e-10;
  return s;
}

/// The same without walls, gravity or air.
inline Settings periodic_box(int cells, double size, int dim = 2) {
  Settings s = box({cells, cells, cells}, size / cells, dim);
  s.walls.axis.fill(Wall::periodic);
  s.fluid.gravity = {0, 0, 0};
  s.fluid.surface = Surface::full;
  return s;
}

/// Particles where inside(x) holds, with the velocity v(x).
template <int Dim, class Real = double, class Inside, class Velocity>
Particles<Dim, Real> seed(const Settings& s, Inside&& inside, Velocity&& v) {
  Particles<Dim, Real> particles;
  const int n = s.seeding.per_axis;
  const double h = s.dx() / n;
  const Real mass = static_cast<Real>(s.fluid.density * std::pow(h, Dim));
  std::array<int, 3> places{1, 1, 1};
  for (std::size_t d = 0; d < Dim; ++d) places[d] = n * s.grid.cells[d];
  std::uint64_t place = 0;
  for (int k = 0; k < places[2]; ++k)
    for (int j = 0; j < places[1]; ++j)
      for (int i = 0; i < places[0]; ++i, ++place) {
        const std::array<int, 3> at{i, j, k};
        Vec<Dim, double> x;
        for (int d = 0; d < Dim; ++d) {
          const double in_place =
              s.seeding.pattern == Pattern::regular
                  ? 0.5
                  : uniform(static_cast<std::uint64_t>(s.seeding.seed), place, static_cast<unsigned>(d));
          x[d] = h * (at[static_cast<std::size_t>(d)] + in_place);
        }
        if (inside(x))
          particles.add(x.template cast<Real>(), Vec<Dim, double>(v(x)).template cast<Real>(), mass,
                        static_cast<std::uint32_t>(particles.size()));
      }
  return particles;
}

template <int Dim> auto everywhere = [](const Vec<Dim, double>&) { return true; };
template <int Dim> auto at_rest = [](const Vec<Dim, double>&) { return Vec<Dim, double>(Vec<Dim, double>::Zero()); };

/// What the particles hold, about the centre of the domain.
template <int Dim, class Real> Totals<Dim> totals(const FluidState<Dim, Real>& s, Pool& pool) {
  return particle_totals<Dim, Real>(s.settings.transfer.kernel, Layout::mac, s.grid, s.particles, s.grid.size_m() / 2,
                                    pool);
}
template <int Dim, class Real> double kinetic_energy(const FluidState<Dim, Real>& s, Pool& pool) {
  return totals(s, pool).kinetic_energy;
}

/// A solver with a pool of its own.
template <int Dim, class Real = double> struct Flow {
  Budget budget;
  Pool pool;
  Budget::Permit permit;
  FluidSolver<Dim, Real> solver;

  Flow(const Settings& s, Particles<Dim, Real> particles, int threads = 1, std::vector<Obstacle> obstacles = {})
      : budget(threads), pool(budget), permit(budget), solver(s, std::move(particles), pool, std::move(obstacles)) {}

  /// In steps of at most dt (0: as long as allowed) that end exactly there.
  void run_to(double time, double dt = 0) {
    while (solver.time() < time * (1 - 1e-12)) {
      const double left = time - solver.time(), most = dt > 0 ? dt : solver.max_dt();
      solver.step(left / std::ceil(left / most * (1 - 1e-12)));
    }
  }

  [[nodiscard]] const FluidState<Dim, Real>& state() const { return solver.state(); }
  [[nodiscard]] const Particles<Dim, Real>& particles() const { return solver.state().particles; }

  [[nodiscard]] double max_speed() const {
    double speed = 0;
    for (std::size_t p = 0; p < particles().size(); ++p)
      speed = std::max(speed, static_cast<double>(particles().velocity(p).norm()));
    return speed;
  }
  /// Kinetic energy of the velocity on the grid.
  [[nodiscard]] double grid_energy() {
    const auto& s = state();
    std::array<bool, Dim> periodic;
    for (int a = 0; a < Dim; ++a) periodic[static_cast<std::size_t>(a)] = s.walls.periodic(a);
    return grid_totals<Dim, Real>(Layout::mac, s.grid, s.m, s.u, Vec<Dim, double>::Zero(), pool, periodic)
        .kinetic_energy;
  }
};

/// A request for the curve that costs a transfer.
inline FrameRequest with_noise() {
  FrameRequest request;
  request.noise = true;
  return request;
}

/// Taylor-Green vortices in the unit square.
inline Vec<2, double> taylor_green(const Vec<2, double>& x) {
  const double k = 2 * std::numbers::pi;
  return {std::sin(k * x[0]) * std::cos(k * x[1]), -std::cos(k * x[0]) * std::sin(k * x[1])};
}

} // namespace flipbook::test
