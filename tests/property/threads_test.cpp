// SPDX-License-Identifier: MIT
// Sorting, transfers and sums give the same bytes for any number of threads.
#include "tests/property/cases.h"

#include "sim/diagnostics/ledger.h"
#include "sim/transfer/transfer.h"

namespace flipbook {
namespace {

template <class C> class ThreadsTest : public testing::Test {};
TYPED_TEST_SUITE(ThreadsTest, Cases);

/// Everything that a step of transfers produces.
template <int Dim, class Real> struct Outcome {
  Particles<Dim, Real> particles;
  std::vector<std::uint32_t> start;
  Components<Dim, Real> m, u;
  Totals<Dim> on_particles, on_grid;
};

template <int Dim, class Real>
Outcome<Dim, Real> run(int count, const Corner& corner, KernelName kernel, Layout layout) {
  Threads threads(count);
  Grid<Dim> grid;
  for (int d = 0; d < Dim; ++d) grid.cells[d] = (Dim == 2 ? 60 : 20) + 5 * d;
  grid.dx = 0.01;
  Outcome<Dim, Real> o;
  o.particles.set_mode(corner.mode);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    Vec<Dim, Real> x, v;
    for (int d = 0; d < Dim; ++d) {
      const auto c = static_cast<std::uint64_t>(d);
      x[d] = static_cast<Real>(uniform(8, i, c) * grid.size_m()[d]);
      v[d] = static_cast<Real>(uniform(9, i, c) - 0.5);
    }
    o.particles.add(x, v, static_cast<Real>(0.5 + uniform(10, i, 0)), i);
    for (std::size_t k = 0; k < o.particles.A.size(); ++k)
      o.particles.A[k].back() = static_cast<Real>(100 * (uniform(11, i, k) - 0.5));
  }
  CellOrder<Dim> order;
  sort_by_cell(o.particles, grid, order, threads.pool);
  o.start = order.start;
  o.m.resize(grid);
  o.u.resize(grid);
  p2g(corner, kernel, layout, grid, o.particles, order, o.m, o.u, threads.pool);
  to_velocity(o.m, o.u, threads.pool);
  auto next = o.u;
  for (auto& f : next)
    for (auto& x : f) x *= Real(0.9);
  g2p(corner, kernel, layout, grid, next, o.u, o.particles, threads.pool);
  const Vec<Dim, double> origin = grid.size_m() / 2;
  o.on_particles = particle_totals(kernel, layout, grid, o.particles, origin, threads.pool);
  o.on_grid = grid_totals(layout, grid, o.m, o.u, origin, threads.pool);
  return o;
}

TYPED_TEST(ThreadsTest, AnyNumberGivesTheSameBytes) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  each_combination({rpic, aflip}, [](const Corner& c, KernelName k, Layout l) {
    const auto one = run<Dim, Real>(1, c, k, l);
    for (const int count : {2, 3, 5}) {
      SCOPED_TRACE(std::to_string(count) + " threads");
      const auto many = run<Dim, Real>(count, c, k, l);
      EXPECT_EQ(many.start, one.start);
      EXPECT_EQ(many.particles.id, one.particles.id);
      EXPECT_EQ(many.particles.x, one.particles.x);
      EXPECT_EQ(many.m, one.m);
      EXPECT_EQ(many.u, one.u);
      EXPECT_EQ(many.particles.v, one.particles.v);
      EXPECT_EQ(many.particles.A, one.particles.A);
      for (const auto& [x, y] : {std::pair{many.on_particles, one.on_particles}, {many.on_grid, one.on_grid}}) {
        EXPECT_EQ(x.mass, y.mass);
        EXPECT_EQ(x.momentum, y.momentum);
        EXPECT_EQ(x.angular_momentum, y.angular_momentum);
        EXPECT_EQ(x.kinetic_energy, y.kinetic_energy);
      }
    }
  });
}

} // namespace
} // namespace flipbook
