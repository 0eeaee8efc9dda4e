// SPDX-License-Identifier: MIT
// How long a step may be.
#include "sim/fluid/fluid_solver.h"
#include "sim/fluid/largest.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
template <int Dim, class Real> double FluidSolver<Dim, Real>::max_dt() const {
  const auto& s = state_;
  const auto count = static_cast<std::int64_t>(s.particles.size());
  const Largest<Real> square = pool_.sum(count, 8192, Largest<Real>{}, [&](std::int64_t begin, std::int64_t end) {
    return largest<Real>(begin, end, [&](std::size_t p) {
      Real sum = 0;
      for (std::size_t d = Dim; d-- > 0;) sum += s.particles.v[d][p] * s.particles.v[d][p];
      return sum;
    });
  });
  double speed = std::sqrt(static_cast<double>(square.value)), gravity = 0;
  for (std::size_t a = 0; a < Dim; ++a) {
    gravity = std::hypot(gravity, s.settings.fluid.gravity[a]);
    if (s.steps == 0) continue;
    const Real *u = s.u[a].data(), *inverse_theta = s.cells.inverse_theta[a].data(), *open = s.walls.open[a].data();
    const Largest<Real> fastest =
        pool_.sum(s.grid.size(), 1 << 14, Largest<Real>{}, [&](std::int64_t begin, std::int64_t end) {
          return largest<Real>(begin, end, [&](std::size_t i) {
            const Real flows = inverse_theta[i] * open[i]; // neither is negative, and neither is tiny
            return flows > 0 ? std::abs(u[i]) : Real(0);
          });
        });
    speed = std::max(speed, static_cast<double>(fastest.value));
  }
  const double dx = s.grid.dx, bound = s.settings.time.dt;
  const double dt = s.settings.time.cfl * dx / std::max(speed + std::sqrt(gravity * dx), 1e-30);
  return s.solids.max_dt(s.time, s.settings.time.cfl, bound > 0 ? std::min(bound, dt) : dt, s.walls);
}

#define FLIPBOOK_BOUNDS(Dim, Real) template double FluidSolver<Dim, Real>::max_dt() const;
FLIPBOOK_BOUNDS(2, float)
FLIPBOOK_BOUNDS(2, double)
FLIPBOOK_BOUNDS(3, float)
FLIPBOOK_BOUNDS(3, double)
#undef FLIPBOOK_BOUNDS

} // namespace flipbook
