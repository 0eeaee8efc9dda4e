// SPDX-License-Identifier: MIT
#include "sim/fluid/energy.h"

#include "sim/transfer/interpolate.h"

namespace flipbook {
namespace {

constexpr std::int64_t grain = 4096;

template <int Dim, class Real> Totals<Dim> totals(const FluidState<Dim, Real>& s, Pool& pool) {
  Vec<Dim, double> origin = s.grid.size_m() / 2;
  for (int d = 0; d < Dim; ++d) origin[d] += s.settings.ledger.origin[static_cast<std::size_t>(d)];
  return particle_totals(s.settings.transfer.kernel, Layout::mac, s.grid, s.particles, origin, pool);
}

/// Sum of value(particle) in a fixed tree.
template <class Value> double sum_over(std::size_t count, Pool& pool, Value&& value) {
  return pool.sum(static_cast<std::int64_t>(count), grain, 0.0, [&](std::int64_t begin, std::int64_t end) {
    double sum = 0;
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) sum += value(p);
    return sum;
  });
}

} // namespace

template <int Dim, class Real> EnergyAccount<Dim> energy_account(const FluidState<Dim, Real>& s, Pool& pool) {
  EnergyAccount<Dim> account{totals(s, pool), 0};
  const auto& g = s.settings.fluid.gravity;
  account.potential = sum_over(s.particles.size(), pool, [&](std::size_t p) {
    double gx = 0;
    for (std::size_t d = 0; d < Dim; ++d) gx += g[d] * static_cast<double>(s.particles.x[d][p]);
    return -static_cast<double>(s.particles.m[p]) * gx;
  });
  return account;
}

template <int Dim, class Real> double kinetic_energy(const FluidState<Dim, Real>& s, Pool& pool) {
  return totals(s, pool).kinetic_energy;
}

template <int Dim, class Real>
double grid_gain(const FluidState<Dim, Real>& s, const Components<Dim, Real>& u, Components<Dim, Real>& room,
                 Pool& pool) {
  room.resize(s.grid);
  for (std::size_t a = 0; a < Dim; ++a)
    pool.ranges(s.grid.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        room[a][i] = (u[a][i] * u[a][i] - s.u_old[a][i] * s.u_old[a][i]) / 2;
    });
  return with_kernel(s.settings.transfer.kernel, [&](auto k) {
    const Interpolator<decltype(k), Dim, Real> gain(Layout::mac, s.grid, room);
    return sum_over(s.particles.size(), pool, [&](std::size_t p) {
      if (s.ballistic[p]) return 0.0;
      return static_cast<double>(s.particles.m[p]) * static_cast<double>(gain(s.particles.position(p)).sum());
    });
  });
}

#define FLIPBOOK_ENERGY(Dim, Real)                                                                                     \
  template EnergyAccount<Dim> energy_account(const FluidState<Dim, Real>&, Pool&);                                     \
  template double kinetic_energy(const FluidState<Dim, Real>&, Pool&);                                                 \
  template double grid_gain(const FluidState<Dim, Real>&, const Components<Dim, Real>&, Components<Dim, Real>&, Pool&);
FLIPBOOK_ENERGY(2, float)
FLIPBOOK_ENERGY(2, double)
FLIPBOOK_ENERGY(3, float)
FLIPBOOK_ENERGY(3, double)
#undef FLIPBOOK_ENERGY

} // namespace flipbook
