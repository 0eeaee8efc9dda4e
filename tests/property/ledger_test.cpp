// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/core/cross.h"
#include "sim/diagnostics/ledger.h"

namespace flipbook {
namespace {

TEST(Cross, IsTheUsualProduct) {
  EXPECT_EQ((cross<3, double>({1, 2, 3}, {-4, 5, 7})), (Vec<3, double>(2 * 7 - 3 * 5, 3 * -4 - 1 * 7, 1 * 5 - 2 * -4)));
  EXPECT_EQ((cross<2, double>({1, 2}, {-4, 5}))[0], 1 * 5 - 2 * -4);
}

TEST(Ledger, OneParticleByHand) {
  Threads threads(1);
  Grid<2> grid;
  grid.cells = {4, 4};
  grid.dx = 0.5;
  Particles<2, double> p;
  p.set_mode(AffineMode::full);
  p.add({0.6, 0.7}, {3, -2}, 2, 0);
  for (std::size_t i = 0; i < 4; ++i) p.A[i][0] = static_cast<double>(i + 1); // C = (1 2; 3 4)
  const auto t = particle_totals(KernelName::quadratic, Layout::mac, grid, p, {0.1, 0.3}, threads.pool);
  EXPECT_DOUBLE_EQ(t.mass, 2);
  EXPECT_DOUBLE_EQ(t.momentum[0], 6);
  EXPECT_DOUBLE_EQ(t.momentum[1], -4);
  const double D = 0.25 * 0.5 * 0.5;
  EXPECT_NEAR(t.angular_momentum[0], 2 * (0.5 * -2 - 0.4 * 3) + 2 * D * (3 - 2), 1e-14);
  EXPECT_NEAR(t.kinetic_energy, 0.5 * 2 * (9 + 4) + 0.5 * 2 * D * (1 + 4 + 9 + 16), 1e-14);

  // The linear kernel's D depends on the place in the cell, and on MAC faces on the component: on axis 0 the particle
  // is 1.2 cells in, 0.2 from component 0's sample and 0.7 from component 1's; on axis 1 it is 1.4 cells in: 0.9 and
  // 0.4.
  const auto linear = particle_totals(KernelName::linear, Layout::mac, grid, p, {0.1, 0.3}, threads.pool);
  const double D00 = 0.2 * 0.8 / 4, D01 = 0.9 * 0.1 / 4, D10 = 0.7 * 0.3 / 4, D11 = 0.4 * 0.6 / 4;
  EXPECT_NEAR(linear.angular_momentum[0], 2 * (0.5 * -2 - 0.4 * 3) + 2 * (D10 * 3 - D01 * 2), 1e-14);
  EXPECT_NEAR(linear.kinetic_energy, 0.5 * 2 * (9 + 4) + D00 * 1 + D01 * 4 + D10 * 9 + D11 * 16, 1e-14);
}

TEST(Ledger, OneSampleByHand) {
  Threads threads(1);
  Grid<2> grid;
  grid.cells = {4, 4};
  grid.dx = 0.5;
  Components<2, double> m, u;
  m.resize(grid);
  u.resize(grid);
  const auto k = static_cast<std::size_t>(grid.at({Grid<2>::pad + 1, Grid<2>::pad + 2}));
  m[0][k] = 3; // on MAC faces this sample of component 0 lies at (0.5, 1.25)
  u[0][k] = 2;
  const auto t = grid_totals(Layout::mac, grid, m, u, {0.1, 0.25}, threads.pool);
  EXPECT_DOUBLE_EQ(t.mass, 1.5); // the mean of the two components
  EXPECT_DOUBLE_EQ(t.momentum[0], 6);
  EXPECT_DOUBLE_EQ(t.momentum[1], 0);
  EXPECT_NEAR(t.angular_momentum[0], -(1.25 - 0.25) * 6, 1e-14);
  EXPECT_DOUBLE_EQ(t.kinetic_energy, 6);
}

TEST(Ledger, APeriodicAxisCountsOnePeriod) {
  Threads threads(1);
  Grid<3> grid;
  grid.cells = {4, 6, 8};
  Components<3, float> m, u;
  m.resize(grid);
  u.resize(grid);
  for (auto& f : m) std::fill(f.begin(), f.end(), 1.0f);
  for (auto& f : u) std::fill(f.begin(), f.end(), 1.0f);
  const auto mass = [&](std::array<bool, 3> periodic) {
    return grid_totals(Layout::mac, grid, m, u, {0, 0, 0}, threads.pool, periodic).mass;
  };
  EXPECT_NEAR(mass({true, true, true}), 4 * 6 * 8, 1e-9);
  EXPECT_NEAR(mass({false, true, false}), (4 + 5) * 6 * (8 + 5), 1e-9);
}

template <class C> class LedgerTest : public testing::Test {};
TYPED_TEST_SUITE(LedgerTest, Cases);

/// Spin stored as omega and the same spin stored as an antisymmetric C are one motion.
TYPED_TEST(LedgerTest, OmegaAndItsMatrixHoldTheSame) {
  constexpr int Dim = TypeParam::dim;
  Threads threads(1);
  each_combination({rpic}, [&](const Corner& c, KernelName k, Layout l) {
    const Trial<Dim, typename TypeParam::Real> trial(c.mode, 30, 2, threads.pool);
    auto matrix = trial.particles;
    matrix.set_mode(AffineMode::full);
    for (std::size_t p = 0; p < matrix.size(); ++p)
      for (int a = 0; a < Dim; ++a)
        for (int d = 0; d < Dim; ++d) {
          if (a == d) continue; // (omega x r)_a: the part along r_d
          const auto omega = trial.particles.A[static_cast<std::size_t>(cross_axis<Dim>(d, a))][p];
          matrix.A[static_cast<std::size_t>(a * Dim + d)][p] = Dim == 2             ? (a == 1 ? omega : -omega)
                                                               : (a == (d + 1) % 3) ? omega
                                                                                    : -omega;
        }
    const auto x = particle_totals(k, l, trial.grid, trial.particles, trial.origin, threads.pool);
    const auto y = particle_totals(k, l, trial.grid, matrix, trial.origin, threads.pool);
    EXPECT_LT((x.angular_momentum - y.angular_momentum).norm(), 1e-12);
    EXPECT_NEAR(x.kinetic_energy, y.kinetic_energy, 1e-12 * x.kinetic_energy);
  });
}

} // namespace
} // namespace flipbook
