// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/fluid/box.h"
#include "sim/transfer/stencil.h"

#include <algorithm>
#include <bit>

namespace flipbook {
namespace {

template <class C> class OrderTest : public testing::Test {};
TYPED_TEST_SUITE(OrderTest, Cases);

/// Enough particles for several chunks of the sort, in no order at all, with every column telling its particle.
template <int Dim, class Real> Particles<Dim, Real> scattered(const Grid<Dim>& grid) {
  Particles<Dim, Real> p;
  p.set_mode(AffineMode::full);
  for (std::uint32_t i = 0; i < 30000; ++i) {
    Vec<Dim, Real> x;
    for (int d = 0; d < Dim; ++d)
      x[d] = static_cast<Real>(uniform(5, i, static_cast<std::uint64_t>(d)) * grid.size_m()[d]);
    p.add(x, 2 * x, static_cast<Real>(i), i);
    for (auto& column : p.A) column.back() = static_cast<Real>(i) / 2;
  }
  return p;
}

TYPED_TEST(OrderTest, SortIsAStablePermutationIntoCells) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  Threads threads(2);
  Grid<Dim> grid;
  for (int d = 0; d < Dim; ++d) grid.cells[d] = 17 + 3 * d;
  grid.dx = 0.03;
  const Particles<Dim, Real> before = scattered<Dim, Real>(grid);
  Particles<Dim, Real> after = before;
  CellOrder<Dim> order;
  for (int repeat = 0; repeat < 2; ++repeat) { // the second time from sorted particles, with the scratch in use
    sort_by_cell(after, grid, order, threads.pool);
    ASSERT_EQ(order.start.size(), order.cells.size() + std::size_t{1});
    ASSERT_EQ(order.start.front(), 0u);
    ASSERT_EQ(order.start.back(), before.size());
    std::vector<char> seen(before.size(), 0);
    for (std::size_t c = 0; c + 1 < order.start.size(); ++c)
      for (std::uint32_t p = order.start[c]; p < order.start[c + 1]; ++p) {
        const std::size_t i = after.id[p];
        ASSERT_EQ(seen[i]++, 0);
        ASSERT_EQ(order.cells.number(cell_of(grid, after.position(p))), c);
        ASSERT_TRUE(p == order.start[c] || after.id[p - 1] < i) << "the order within a cell has changed";
        ASSERT_EQ(after.position(p), before.position(i));
        ASSERT_EQ(after.velocity(p), before.velocity(i));
        ASSERT_EQ(after.m[p], before.m[i]);
        for (std::size_t k = 0; k < after.A.size(); ++k) ASSERT_EQ(after.A[k][p], before.A[k][i]);
      }
  }
}

TYPED_TEST(OrderTest, NoParticlesIsFine) {
  constexpr int Dim = TypeParam::dim;
  Threads threads(1);
  Grid<Dim> grid;
  Particles<Dim, typename TypeParam::Real> none;
  CellOrder<Dim> order;
  sort_by_cell(none, grid, order, threads.pool);
  EXPECT_EQ(order.start, std::vector<std::uint32_t>(order.cells.size() + std::size_t{1}, 0));
}

TYPED_TEST(OrderTest, NumbersEveryCellOnceAndBlockByBlock) {
  constexpr int Dim = TypeParam::dim;
  Grid<Dim> grid;
  for (int d = 0; d < Dim; ++d) grid.cells[d] = 30 - 7 * d;
  const BlockedCells<Dim> cells(grid);
  std::vector<char> seen(cells.size(), 0);
  each_in(grid, Box<Dim>{Index<Dim>::Zero(), grid.extent()}, [&](const Index<Dim>& cell, std::size_t) {
    const std::uint32_t number = cells.number(cell);
    ASSERT_LT(number, cells.size());
    ASSERT_EQ(seen[number]++, 0);
    const Index<Dim> first = (cell.array() / block_edge) * block_edge;
    ASSERT_EQ(number / cells.per_block, cells.number(first) / cells.per_block);
    ASSERT_EQ(cells.number(first) % cells.per_block, 0u);
  });
}

TYPED_TEST(OrderTest, RowsFindTheirParticles) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  Threads threads(2);
  Grid<Dim> grid;
  grid.cells.setConstant(21);
  grid.dx = 1;
  Particles<Dim, Real> particles;
  for (const std::uint32_t i : {5u, 6u, 13u, 14u, 19u}) { // cells along x, from the pads on: 7, 8, 15, 16, 21
    Vec<Dim, Real> x = Vec<Dim, Real>::Constant(Real(3.5));
    x[0] = static_cast<Real>(i) + Real(0.5);
    particles.add(x, x, Real(1), i);
  }
  CellOrder<Dim> order;
  sort_by_cell(particles, grid, order, threads.pool);
  const CellRow<Dim> row = order.row(Index<Dim>::Constant(5));
  order.row(Index<Dim>::Constant(6)).each_run(0, 25, [](std::size_t, std::size_t) { FAIL() << "an empty row"; });
  for (int first = 0; first <= 25; ++first)
    for (int last = first; last <= 25; ++last) {
      std::vector<std::size_t> expected, found;
      for (const int cell : {7, 8, 15, 16, 21})
        if (cell >= first && cell < last) expected.push_back(static_cast<std::size_t>(cell));
      row.each_run(first, last, [&](std::size_t begin, std::size_t end) {
        ASSERT_LT(begin, end);
        for (; begin < end; ++begin) found.push_back(particles.id[begin] + std::size_t{2});
      });
      ASSERT_EQ(found, expected) << first << " " << last;
    }
}

TYPED_TEST(OrderTest, BlocksVisitEveryParticleOnce) {
  constexpr int Dim = TypeParam::dim;
  Threads threads(3);
  Grid<Dim> grid;
  for (int d = 0; d < Dim; ++d) grid.cells[d] = 30 - 7 * d;
  grid.dx = 0.03;
  auto particles = scattered<Dim, typename TypeParam::Real>(grid);
  CellOrder<Dim> order;
  sort_by_cell(particles, grid, order, threads.pool);
  std::vector<char> visits(particles.size(), 0); // runs are disjoint, so no two threads write one entry
  const auto visit = [&](const Index<Dim>& first) {
    const auto [begin, end] = order.block(first);
    for (std::size_t p = begin; p < end; ++p) ++visits[p];
  };
  each_block(grid, threads.pool, visit);
  EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](char n) { return n == 1; }));
  each_block_at_once(grid, threads.pool, visit);
  EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](char n) { return n == 2; }));
}

/// Blocks that run side by side must not reach one sample: for any particle, no kernel goes beyond `reach` samples from
/// its cell, and blocks of one colour are a block apart.
TYPED_TEST(OrderTest, StencilsStayWithinReachOfTheirCell) {
  using Real = typename TypeParam::Real;
  constexpr int reach = 2;
  static_assert(std::has_single_bit(static_cast<unsigned>(block_edge)) && block_edge > 2 * reach - 1);
  for (const double dx : {0.1, 1.0 / 3, 0.7})
    for (int i = 0; i <= 4000; ++i) {
      // Positions at, just below and just above multiples of half a cell, where roundings decide the cell.
      Real x = static_cast<Real>(dx * (i / 3) / 2);
      if (i % 3 == 1) x = std::nextafter(x, Real(0));
      if (i % 3 == 2) x = std::nextafter(x, Real(1000));
      const Real q = grid_position(x, static_cast<Real>(1 / dx));
      const int cell = static_cast<int>(q);
      for (const KernelName k : kernels)
        with_kernel(k, [&](auto kernel) {
          using K = decltype(kernel);
          for (const Real origin : {Real(0), Real(0.5)}) {
            const AxisStencil<K, Real, NoSecond> s(q - origin);
            const int base = static_cast<int>(s.base);
            ASSERT_GE(base, cell - reach);
            ASSERT_LE(base + K::support - 1, cell + reach);
            // What a tile relies on: all particles of a cell begin at one of two samples (transfer/tile.h).
            ASSERT_GE(base, cell - K::support / 2);
            ASSERT_LE(base, cell - K::support / 2 + 1);
          }
        });
    }
}

} // namespace
} // namespace flipbook
