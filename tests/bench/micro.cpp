// SPDX-License-Identifier: MIT
// Small pieces by themselves, for whoever changes one of them: a kernel's weights, one sweep of P2G and of G2P, the
// sort, the level set. The argument of the larger ones is the number of cells along each axis; 8 particles a cell.
#include "sim/core/random.h"
#include "sim/fluid/level_set.h"
#include "sim/transfer/transfer.h"

#include <benchmark/benchmark.h>

#include <array>

namespace flipbook {
namespace {

constexpr int Dim = 3;
using Real = float;

template <class K> void weights(benchmark::State& state) {
  std::array<Real, 256> at{};
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = static_cast<Real>(10 + uniform(1, i, 0));
  for (auto _ : state)
    for (const Real q : at) {
      const auto w = K::weights(q - static_cast<Real>(K::base(q)));
      benchmark::DoNotOptimize(w);
    }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(at.size()));
}
BENCHMARK(weights<Linear>);
BENCHMARK(weights<Quadratic>);
BENCHMARK(weights<Cubic>);

/// A cube full of particles, with one thread.
struct Cube {
  explicit Cube(int n) : budget(1), pool(budget), permit(budget), walls(grid_with(n), WallSettings{}) {
    grid = grid_with(n);
    const auto across = static_cast<std::uint32_t>(2 * n);
    for (std::uint32_t p = 0; p < across * across * across; ++p) {
      const std::array<std::uint32_t, Dim> place{p % across, p / across % across, p / across / across};
      Vec<Dim, Real> x, v;
      for (int d = 0; d < Dim; ++d) {
        const auto a = static_cast<std::size_t>(d);
        x[d] = static_cast<Real>((place[a] + 0.99 * uniform(1, p, a)) * grid.dx / 2);
        v[d] = static_cast<Real>(2 * uniform(2, p, a) - 1);
      }
      particles.add(x, v, Real(1), p);
    }
    particles.set_mode(AffineMode::full);
    sort_by_cell(particles, grid, order, pool);
    for (Components<Dim, Real>* field : {&m, &u}) field->resize(grid);
    phi.resize(static_cast<std::size_t>(grid.size()));
  }

  static Grid<Dim> grid_with(int n) {
    Grid<Dim> g;
    g.cells = Index<Dim>::Constant(n);
    g.dx = 1.0 / n;
    return g;
  }

  void count(benchmark::State& state) const {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles.size()));
  }

  Budget budget;
  Pool pool;
  Budget::Permit permit;
  Grid<Dim> grid;
  Walls<Dim, Real> walls;
  Particles<Dim, Real> particles;
  CellOrder<Dim> order;
  Components<Dim, Real> m, u;
  Field<Real> phi;
};

const Corner apic{.mode = AffineMode::full};

template <KernelName kernel> void to_grid(benchmark::State& state) {
  Cube c(static_cast<int>(state.range(0)));
  for (auto _ : state) p2g(apic, kernel, Layout::mac, c.grid, c.particles, c.order, c.m, c.u, c.pool);
  c.count(state);
}
BENCHMARK(to_grid<KernelName::linear>)->Arg(16)->Arg(32);
BENCHMARK(to_grid<KernelName::quadratic>)->Arg(16)->Arg(32);

template <KernelName kernel> void to_particles(benchmark::State& state) {
  Cube c(static_cast<int>(state.range(0)));
  p2g(apic, kernel, Layout::mac, c.grid, c.particles, c.order, c.m, c.u, c.pool);
  to_velocity(c.m, c.u, c.pool);
  for (auto _ : state) g2p(apic, kernel, Layout::mac, c.grid, c.u, c.u, c.particles, c.pool);
  c.count(state);
}
BENCHMARK(to_particles<KernelName::linear>)->Arg(16)->Arg(32);
BENCHMARK(to_particles<KernelName::quadratic>)->Arg(16)->Arg(32);

void sort(benchmark::State& state) {
  Cube c(static_cast<int>(state.range(0)));
  for (auto _ : state) sort_by_cell(c.particles, c.grid, c.order, c.pool);
  c.count(state);
}
BENCHMARK(sort)->Arg(16)->Arg(32);

void surface(benchmark::State& state) {
  Cube c(static_cast<int>(state.range(0)));
  const double radius = particle_radius<Dim>(c.grid.dx, 2);
  for (auto _ : state) level_set(c.grid, c.walls, c.particles, c.order, radius, c.phi, c.pool);
  c.count(state);
}
BENCHMARK(surface)->Arg(16)->Arg(32);

} // namespace
} // namespace flipbook

BENCHMARK_MAIN();
