// SPDX-License-Identifier: MIT
// The plain transfers that `flipbook verify` compares the solver's with, against sums done by hand.
#include "tests/property/cases.h"

#include "sim/diagnostics/bench.h"
#include "sim/diagnostics/counterexamples.h"

#include <limits>

namespace flipbook {
namespace {

/// One particle a quarter of a cell right of a node and half a cell above it; dx = 2.
struct OneParticle {
  Grid<2> grid;
  Particles<2, double> particles;
  OneParticle() {
    grid.cells = {6, 6};
    grid.dx = 2;
    particles.set_mode(AffineMode::full);
    particles.add({6.5, 7}, {3, -1}, 5, 0);
    for (std::size_t i = 0; i < 4; ++i) particles.A[i][0] = static_cast<double>(i + 1); // C = (1 2; 3 4)
  }
  [[nodiscard]] std::size_t node(int i, int j) const {
    return static_cast<std::size_t>(grid.at({Grid<2>::pad + i, Grid<2>::pad + j}));
  }
};

TEST(PlainTransfer, LinearWeightsByHand) {
  const OneParticle one;
  const PlainTransfer<2> plain(AffineMode::full, KernelName::linear, Layout::nodes, one.grid);
  const auto p = plain.from_solver(one.particles);
  // D = dx^2 diag(f (1 - f)): f = 1/4 and 1/2.
  EXPECT_NEAR(p[0].B(0, 0), 1 * 4 * 3.0 / 16, 1e-14);
  EXPECT_NEAR(p[0].B(1, 0), 3 * 4 * 3.0 / 16, 1e-14);
  EXPECT_NEAR(p[0].B(0, 1), 2 * 4 * 1.0 / 4, 1e-14);
  Components<2, double> m, momentum;
  plain.to_grid(p, m, momentum);
  EXPECT_NEAR(m[0][one.node(3, 3)], 5 * 0.75 * 0.5, 1e-14);
  EXPECT_NEAR(m[1][one.node(4, 3)], 5 * 0.25 * 0.5, 1e-14);
  EXPECT_EQ(m[0][one.node(5, 3)], 0);
  // x_i - x_p = (1.5, 1) for node (4, 4).
  EXPECT_NEAR(momentum[0][one.node(4, 4)], 5 * 0.25 * 0.5 * (3 + 1 * 1.5 + 2 * 1), 1e-14);
  EXPECT_NEAR(momentum[1][one.node(4, 4)], 5 * 0.25 * 0.5 * (-1 + 3 * 1.5 + 4 * 1), 1e-14);
}

TEST(PlainTransfer, GathersTheGradientThatAFieldHas) {
  const OneParticle one;
  Components<2, double> v;
  v.resize(one.grid);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) v[0][one.node(i, j)] = 2.0 * i * 10 - 2.0 * j; // 10 x - y
  for (const KernelName k : kernels)
    for (const Fault fault : {Fault::none, Fault::gradient_form}) { // both are right about an affine field
      const PlainTransfer<2> plain(AffineMode::full, k, Layout::nodes, one.grid, fault);
      auto p = plain.from_solver(one.particles);
      plain.to_particles(v, p);
      EXPECT_NEAR(p[0].v[0], 10 * 6.5 - 7, 1e-12);
      EXPECT_NEAR(p[0].v[1], 0, 1e-12);
      const auto C = plain.solver_state(p[0]);
      EXPECT_NEAR(C[0], 10, 1e-12);
      EXPECT_NEAR(C[1], -1, 1e-12);
      EXPECT_NEAR(C[2], 0, 1e-12);
      EXPECT_NEAR(C[3], 0, 1e-12);
    }
}

TEST(PlainTransfer, AMidpointMoveFollowsTheCurve) {
  const OneParticle one;
  Components<2, double> v;
  v.resize(one.grid);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) v[0][one.node(i, j)] = -(2.0 * j - 6), v[1][one.node(i, j)] = 2.0 * i - 6;
  const PlainTransfer<2> plain(AffineMode::full, KernelName::linear, Layout::nodes, one.grid);
  // About (6, 6): from (1/2, 1) the velocity is (-1, 1/2), and (-1 - dt/4, 1/2 - dt/2) half a step on.
  const Vec<2, double> move = plain.midpoint_move(v, {6.5, 7}, 0.5);
  EXPECT_NEAR(move[0], 0.5 * (-1 - 0.125), 1e-13);
  EXPECT_NEAR(move[1], 0.5 * (0.5 - 0.25), 1e-13);
}

TEST(PlainTransfer, AClampedKernelHasLostItsFirstMoment) {
  OneParticle one;
  one.particles.set_position(0, {0.5, 7}); // a quarter of a cell from the wall: the node at -dx is out of reach
  const auto first_moment = [&](Fault fault) {
    const PlainTransfer<2> plain(AffineMode::full, KernelName::quadratic, Layout::nodes, one.grid, fault);
    Components<2, double> x;
    x.resize(one.grid);
    for (int j = -2; j < 9; ++j)
      for (int i = -2; i < 9; ++i) x[0][one.node(i, j)] = 2.0 * i, x[1][one.node(i, j)] = 2.0 * j;
    return plain.velocity(x, one.particles.position(0)); // sum w x_i
  };
  EXPECT_LT((first_moment(Fault::none) - one.particles.position(0)).norm(), 1e-13);
  // Weights at -dx, 0, dx: 1/32, 11/16, 9/32. Without the first, (9/32) / (31/32) dx.
  EXPECT_NEAR(first_moment(Fault::clamped_kernel)[0], 2 * 9.0 / 31, 1e-13);
  EXPECT_NEAR(first_moment(Fault::clamped_kernel)[1], 7, 1e-13);
}

TEST(Bench, MovedNodesByHand) {
  Threads threads(1);
  const OneParticle one;
  for (const Layout layout : layouts) {
    Bench<2, double> b(apic.corner, KernelName::linear, layout, 1, threads.pool);
    const auto k = static_cast<std::size_t>(b.trial.grid.at({Grid<2>::pad + 1, Grid<2>::pad + 2}));
    Components<2, double> v;
    v.resize(b.trial.grid);
    b.m[0][k] = b.m[1][k] = 2;
    v[0][k] = 3;
    v[1][k] = -4;
    const double dx = b.trial.grid.dx, half = layout == Layout::mac ? dx / 2 : 0, dt = 0.1;
    const Vec<2, double> o = b.trial.origin;
    // Component 0 lies at (dx, 2 dx + half), component 1 at (dx + half, 2 dx). On nodes both move by dt (3, -4).
    const double along_y = layout == Layout::nodes ? dt * -4 : 0, along_x = layout == Layout::nodes ? dt * 3 : 0;
    const double L = (dx + half + along_x - o[0]) * 2 * -4 - (2 * dx + half + along_y - o[1]) * 2 * 3;
    EXPECT_NEAR(b.moved_angular_momentum(v, dt)[0], L, 1e-14);
  }
}

TEST(Bench, ANotANumberIsTheWorstOfAll) {
  double worst = 1;
  keep_worst(worst, 0.5);
  EXPECT_EQ(worst, 1);
  keep_worst(worst, std::numeric_limits<double>::quiet_NaN());
  keep_worst(worst, 2);
  EXPECT_TRUE(std::isnan(worst));
}

template <class C> class PlainTransferTest : public testing::Test {};
TYPED_TEST_SUITE(PlainTransferTest, Cases);

/// What the report says that a particle holds is what the ledger counts.
TYPED_TEST(PlainTransferTest, HasTheTotalsOfTheLedger) {
  constexpr int Dim = TypeParam::dim;
  Threads threads(1);
  each_combination({pic, rpic, apic}, [&](const Corner& c, KernelName k, Layout l) {
    const Bench<Dim, typename TypeParam::Real> b(c, k, l, 5, threads.pool);
    const PlainTransfer<Dim> plain(c.mode, k, l, b.trial.grid);
    const auto found = plain.totals(plain.from_solver(b.trial.particles), b.trial.origin);
    const auto expected = b.on_particles();
    EXPECT_LT((found.momentum - expected.momentum).norm(), 1e-12);
    // The ledger takes the fraction that the transfers round to, which only the linear kernel's D depends on.
    const bool rounds = k == KernelName::linear && std::is_same_v<typename TypeParam::Real, float>;
    EXPECT_LT((found.angular_momentum - expected.angular_momentum).norm(), rounds ? 1e-6 : 1e-12);
    EXPECT_GT(found.angular_momentum.norm(), 0.1);
  });
}

} // namespace
} // namespace flipbook
