// SPDX-License-Identifier: MIT
#include "sim/fluid/advect.h"

#include "sim/transfer/interpolate.h"

namespace flipbook {
namespace {

constexpr std::int64_t grain = 2048;

/// The displacement of one step. Stages that leave the domain see the velocity at the wall, or across the periodic
/// side.
template <class Velocity, int Dim, class Real>
Vec<Dim, Real> displacement(Advection method, const Velocity& velocity, const Walls<Dim, Real>& walls,
                            const Vec<Dim, Real>& x, Real dt) {
  const auto at = [&](Vec<Dim, Real> y) {
    walls.confine(y);
    return y.allFinite() ? velocity(y) : y; // a particle that stopped being finite is reported at the end of the step
  };
  const Vec<Dim, Real> k1 = velocity(x);
  if (method == Advection::rk1) return dt * k1;
  const Vec<Dim, Real> k2 = at(x + dt / 2 * k1);
  if (method == Advection::rk2) return dt * k2;
  const Vec<Dim, Real> k3 = at(x + Real(0.75) * dt * k2);
  return dt / 9 * (2 * k1 + 3 * k2 + 4 * k3);
}

} // namespace

template <int Dim, class Real>
bool advect(Advection method, KernelName kernel, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
            const Components<Dim, Real>& u, double dt, const std::vector<std::uint8_t>& ballistic,
            Particles<Dim, Real>& particles, Pool& pool) {
  return with_kernel(kernel, [&](auto k) {
    const Interpolator<decltype(k), Dim, Real> velocity(Layout::mac, grid, u);
    const auto move = [&](std::int64_t begin, std::int64_t end) {
      unsigned walls_met = 0;
      const Real step = static_cast<Real>(dt);
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
        Vec<Dim, Real> x = particles.position(p), v = particles.velocity(p);
        if (!ballistic[p]) {
          x += displacement(method, velocity, walls, x, step);
          walls_met |= walls.confine(x);
        } else {
          x += step * v;
          const unsigned met = walls.confine(x);
          walls_met |= met;
          for (int a = 0; a < Dim; ++a) {
            if (met >> (2 * a) & 1) v[a] = std::max(v[a], Real(0));
            if (met >> (2 * a + 1) & 1) v[a] = std::min(v[a], Real(0));
          }
          particles.set_velocity(p, v);
        }
        particles.set_position(p, x);
      }
      return walls_met != 0 ? 1 : 0;
    };
    return pool.sum(static_cast<std::int64_t>(particles.size()), grain, 0, move) > 0;
  });
}

template <int Dim, class Real>
void accelerate_ballistic(const std::array<double, 3>& gravity, double dt, const std::vector<std::uint8_t>& ballistic,
                          Particles<Dim, Real>& particles, Pool& pool) {
  pool.ranges(static_cast<std::int64_t>(particles.size()), grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t d = 0; d < Dim; ++d) {
      const Real dv = static_cast<Real>(dt * gravity[d]);
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
        if (ballistic[p]) particles.v[d][p] += dv;
    }
  });
}

#define FLIPBOOK_ADVECT(Dim, Real)                                                                                     \
  template bool advect(Advection, KernelName, const Grid<Dim>&, const Walls<Dim, Real>&, const Components<Dim, Real>&, \
                       double, const std::vector<std::uint8_t>&, Particles<Dim, Real>&, Pool&);                        \
  template void accelerate_ballistic(const std::array<double, 3>&, double, const std::vector<std::uint8_t>&,           \
                                     Particles<Dim, Real>&, Pool&);
FLIPBOOK_ADVECT(2, float)
FLIPBOOK_ADVECT(2, double)
FLIPBOOK_ADVECT(3, float)
FLIPBOOK_ADVECT(3, double)
#undef FLIPBOOK_ADVECT

} // namespace flipbook
