// SPDX-License-Identifier: MIT
// How long a step may be, and whether it went well.
#include "sim/fluid/fluid_solver.h"

#include <cmath>

namespace flipbook {

template <int Dim, class Real> double FluidSolver<Dim, Real>::max_dt() const {
  const auto& s = state_;
  const auto count = static_cast<std::int64_t>(s.particles.size());
  constexpr std::int64_t grain = 8192;
  std::vector<double> fastest(static_cast<std::size_t>((count + grain - 1) / grain), 0.0);
  pool_.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
    Real square = 0;
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      square = std::max(square, s.particles.velocity(p).squaredNorm());
    fastest[static_cast<std::size_t>(begin / grain)] = std::sqrt(static_cast<double>(square));
  });
  double speed = 0, gravity = 0;
  for (const double v : fastest) speed = std::max(speed, v);
  for (int a = 0; a < Dim; ++a) {
    gravity = std::hypot(gravity, s.settings.fluid.gravity[static_cast<std::size_t>(a)]);
    if (s.steps == 0) continue;
    const auto& u = s.u[static_cast<std::size_t>(a)];
    for (std::size_t i = 0; i < u.size(); ++i)
      if (s.cells.inverse_theta[static_cast<std::size_t>(a)][i] > 0 && s.walls.open[static_cast<std::size_t>(a)][i] > 0)
        speed = std::max(speed, std::abs(static_cast<double>(u[i])));
  }
  const double dx = s.grid.dx, bound = s.settings.time.dt;
  const double dt = s.settings.time.cfl * dx / std::max(speed + std::sqrt(gravity * dx), 1e-30);
  return s.solids.max_dt(s.time, s.settings.time.cfl, bound > 0 ? std::min(bound, dt) : dt, s.walls);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::check_finite() const {
  const auto& particles = state_.particles;
  const auto count = static_cast<std::int64_t>(particles.size());
  const auto bad = [&](std::size_t p) {
    Real zero = 0; // stays zero unless something is not finite
    for (std::size_t d = 0; d < Dim; ++d) zero += 0 * particles.x[d][p] + 0 * particles.v[d][p];
    for (const auto& column : particles.A) zero += 0 * column[p];
    return zero != 0;
  };
  pool_.ranges(count, 8192, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      if (bad(p)) throw NonFiniteError(title(), state_.steps, state_.time, particles.id[p]);
  });
}

#define FLIPBOOK_BOUNDS(Dim, Real)                                                                                     \
  template double FluidSolver<Dim, Real>::max_dt() const;                                                              \
  template void FluidSolver<Dim, Real>::check_finite() const;
FLIPBOOK_BOUNDS(2, float)
FLIPBOOK_BOUNDS(2, double)
FLIPBOOK_BOUNDS(3, float)
FLIPBOOK_BOUNDS(3, double)
#undef FLIPBOOK_BOUNDS

} // namespace flipbook
