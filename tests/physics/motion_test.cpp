// SPDX-License-Identifier: MIT
// Motions whose outcome is known without a computation: free fall, symmetry, drops in the air, conserved momentum.
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

#include <limits>

namespace flipbook::test {
namespace {

class EveryScheme : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(All, EveryScheme, testing::Range(0, 5),
                         [](const auto& run) { return std::string(scheme_names[run.param]); });

template <int Dim> void expect_free_fall(int scheme, Splitting splitting) {
  Settings s = box({16, 24, 16}, 1.0 / 16, Dim);
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  s.seeding.pattern = Pattern::jittered;
  const auto seeded = seed<Dim>(
      s,
      [](const auto& x) {
        auto r = x;
        r.setConstant(0.5);
        r[1] = 1.1;
        return (x - r).norm() < 0.25;
      },
      [](const auto& x) {
        auto v = x;
        v.setZero();
        v[0] = 0.2;
        return v;
      });
  Flow<Dim> flow(s, seeded);
  const double dt = 0.01, g = 9.81;
  const int steps = 20;
  for (int i = 0; i < steps; ++i) flow.solver.step(dt);
  // By each step, g dt^2 / 2 times: the velocity at its end; exactly; the one at its start, then the one at its middle.
  const double late = splitting == Splitting::lie ? 1 : splitting == Splitting::midpoint ? 0 : -0.5;
  const double fallen = g * dt * dt * steps * (steps + late) / 2;
  double worst = 0;
  for (std::size_t p = 0; p < seeded.size(); ++p) {
    const auto start = seeded.position(flow.particles().id[p]), x = flow.particles().position(p);
    worst = std::max({worst, std::abs(x[0] - start[0] - 0.2 * steps * dt), std::abs(x[1] - start[1] + fallen),
                      std::abs(flow.particles().velocity(p)[1] + g * steps * dt)});
  }
  // Particles that leave the liquid for a step or two fly exactly in a reflection, unlike the liquid.
  EXPECT_LT(worst, splitting == Splitting::reflection ? g * dt * dt : 1e-9) << Dim << "D";
}

TEST_P(EveryScheme, FreeFallKeepsTheShape) {
  expect_free_fall<2>(GetParam(), Splitting::lie);
  expect_free_fall<2>(GetParam(), Splitting::midpoint);
  expect_free_fall<2>(GetParam(), Splitting::reflection);
  expect_free_fall<3>(GetParam(), Splitting::lie);
}

TEST_P(EveryScheme, SymmetricStaysSymmetric) {
  Settings s = box({32, 32, 32}, 1.0 / 32);
  s.transfer.scheme = GetParam();
  const auto seeded = seed<2>(
      s, [](const auto& x) { return x[1] < 0.5 && (x[0] < 0.25 || x[0] > 0.75); }, at_rest<2>);
  Flow<2> flow(s, seeded);
  for (int i = 0; i < 40; ++i) flow.solver.step(0.005);
  // Rows are seeded from left to right, so the mirror image of a particle is the last but so many of its row.
  std::vector<Vec<2, double>> x(seeded.size());
  for (std::size_t p = 0; p < seeded.size(); ++p) x[flow.particles().id[p]] = flow.particles().position(p);
  const std::size_t row = 32;
  double worst = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    const std::size_t mirror = p / row * row + (row - 1 - p % row);
    worst = std::max({worst, std::abs(x[p][0] + x[mirror][0] - 1), std::abs(x[p][1] - x[mirror][1])});
  }
  EXPECT_LT(x.back()[1], seeded.position(x.size() - 1)[1] - 0.1); // it moved
  EXPECT_LT(worst, 1e-6);
}

/// One drop alone is no liquid cell most of the time, and falls like a stone either way.
TEST_P(EveryScheme, LonelyParticleFallsLikeAStone) {
  Settings s = box({16, 32, 16}, 1.0 / 16);
  s.transfer.scheme = GetParam();
  Particles<2, double> one;
  one.add({0.313, 1.7}, {0.01, 0.5}, 1, 0); // along the side of a column of cells
  Flow<2> flow(s, one);
  int ballistic = 0;
  const double dt = 0.005;
  for (int i = 1; i <= 60; ++i) {
    flow.solver.step(dt);
    ballistic += flow.state().ballistic[0];
    EXPECT_NEAR(flow.particles().velocity(0)[1], 0.5 - 9.81 * i * dt, 1e-9);
    EXPECT_NEAR(flow.particles().velocity(0)[0], 0.01, 1e-9);
  }
  EXPECT_GT(ballistic, 5);
  EXPECT_NEAR(flow.solver.ledger()->transfer_loss(), 0, 1e-9); // gravity's work is not the transfer's
  EXPECT_NEAR(flow.particles().position(0)[0], 0.313 + 0.01 * 60 * dt, 1e-9);
}

TEST(Ballistic, ContactTakesTheVelocityIntoTheWallOnly) {
  Settings s = box({8, 8, 8}, 1);
  s.fluid.gravity = {0, 0, 0};
  Particles<2, double> one;
  one.add({0.05, 4.05}, {-3, 2}, 1, 0); // farther from its cell's centre than the radius
  Flow<2> flow(s, one);
  ASSERT_EQ(flow.state().ballistic[0], 1);
  flow.solver.step(0.1);
  EXPECT_EQ(flow.particles().velocity(0), (Vec<2, double>(0, 2)));
  EXPECT_NEAR(flow.particles().position(0)[1], 4.25, 1e-12);
}

/// The velocity of u_old in the air must be extrapolated just as that of u, or the difference shakes FLIP's particles.
TEST(Flip, SurfaceParticlesKeepTheirVelocityWhereNothingAccelerates) {
  Settings s = box({32, 32, 32}, 1.0 / 32);
  s.fluid.gravity = {0, 0, 0};
  s.transfer.scheme = flip;
  const auto shear = [](const auto& x) { return Vec<2, double>(x[1] - 0.5, 0); };
  const auto seeded = seed<2>(
      s, [](const auto& x) { return std::abs(x[1] - 0.5) < 0.1875 && std::abs(x[0] - 0.5) < 0.1875; }, shear);
  Flow<2> flow(s, seeded);
  flow.solver.step(1e-6);
  double worst = 0;
  for (std::size_t p = 0; p < seeded.size(); ++p)
    worst = std::max(worst, (flow.particles().velocity(p) - seeded.velocity(flow.particles().id[p])).norm());
  EXPECT_LT(worst, 1e-9);
}

/// Transfers keep momentum exactly; the projection of an evenly filled box does so up to how even it is.
TEST_P(EveryScheme, MomentumOfAPeriodicBox) {
  Settings s = periodic_box(24, 1);
  s.transfer.scheme = GetParam();
  const auto flow_through = [](const auto& x) { return Vec<2, double>(taylor_green(x) + Vec<2, double>(1, 0.5)); };
  Flow<2> flow(s, seed<2>(s, everywhere<2>, flow_through));
  const auto momentum = [&] {
    return particle_totals(KernelName::linear, Layout::mac, flow.state().grid, flow.particles(), Vec<2, double>(0, 0),
                           flow.pool)
        .momentum;
  };
  const Vec<2, double> before = momentum();
  flow.run_to(0.25, 0.01);
  EXPECT_LT((momentum() - before).norm(), 5e-3 * before.norm());
}

/// A velocity that is all gradient is gone after one step, whichever way the step is split.
TEST_P(EveryScheme, ProjectionTakesAGradientAway) {
  for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
    Settings s = periodic_box(32, 1);
    s.transfer.scheme = GetParam();
    s.time.splitting = splitting;
    const double k = 2 * std::numbers::pi;
    Flow<2> flow(s, seed<2>(s, everywhere<2>,
                            [&](const auto& x) { return Vec<2, double>(std::sin(k * x[0]), std::sin(k * x[1])); }));
    const double before = kinetic_energy(flow.state(), flow.pool);
    flow.solver.step(1e-5);
    EXPECT_LT(kinetic_energy(flow.state(), flow.pool), 1e-3 * before);
  }
}

TEST(MaxDt, FollowsSpeedGravityAndTheBound) {
  Settings s = box({16, 16, 16}, 1.0 / 16);
  const double dx = 1.0 / 16;
  const auto at_speed = [&](double v) {
    return Flow<2>(s,
                   seed<2>(
                       s, [](const auto& x) { return x[1] < 0.5; }, [&](const auto&) { return Vec<2, double>(v, 0); }))
        .solver.max_dt();
  };
  EXPECT_NEAR(at_speed(0), 0.5 * dx / std::sqrt(9.81 * dx), 1e-12);
  EXPECT_NEAR(at_speed(3), 0.5 * dx / (3 + std::sqrt(9.81 * dx)), 1e-12);
  s.time.dt = 1e-3;
  EXPECT_EQ(at_speed(3), 1e-3);
}

TEST(Spacing, PartsParticlesThatCrowd) {
  Settings s = box({16, 16, 16}, 1.0 / 16);
  s.fluid.gravity = {0, 0, 0};
  const auto closest = [&](double strength) {
    s.fluid.spacing = strength;
    auto crowd = seed<2>(
        s, [](const auto& x) { return x[1] < 0.5; }, at_rest<2>);
    crowd.set_position(100, crowd.position(101) + Vec<2, double>(1e-3, 0));
    crowd.set_position(200, crowd.position(201)); // in one place
    Flow<2> flow(s, crowd);
    for (int i = 0; i < 10; ++i) flow.solver.step(1e-6);
    double nearest = 1;
    for (std::size_t p = 0; p < crowd.size(); ++p)
      for (std::size_t q = 0; q < p; ++q)
        nearest = std::min(nearest, (flow.particles().position(p) - flow.particles().position(q)).norm());
    return nearest * 32; // in spacings
  };
  EXPECT_LT(closest(0), 1e-3);
  EXPECT_GT(closest(0.5), 0.4);
}

TEST(NonFinite, IsReportedWithSchemeStepAndParticle) {
  Settings s = box({8, 8, 8}, 1);
  auto particles = seed<2>(
      s, [](const auto& x) { return x[1] < 4; }, at_rest<2>);
  Flow<2> flow(s, particles);
  flow.solver.step(0.01);
  ASSERT_EQ(
      flow.solver.set("fluid.gravity", std::vector<double>{0, std::numeric_limits<double>::max(), 0}).message.empty(),
      false);
  particles.v[1][17] = std::numeric_limits<double>::quiet_NaN();
  try {
    Flow<2> bad(s, particles);
    FAIL() << "not refused";
  } catch (const NonFiniteError& e) {
    EXPECT_EQ(e.particle, 17U);
    EXPECT_NE(std::string(e.what()).find("APIC"), std::string::npos);
  }
}

} // namespace
} // namespace flipbook::test
