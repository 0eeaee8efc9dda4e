// SPDX-License-Identifier: MIT
// Obstacles that move, curved walls, and the particles around them.
#include "sim/boundary/mesh_shape.h"
#include "tests/physics/solids.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

const Point middle{0.5, 0.5, 0.5};

Settings weightless(int cells, int dim = 2) {
  Settings s = box({cells, cells, cells}, 1.0 / cells, dim);
  s.fluid.gravity = {0, 0, 0};
  return s;
}

// === Potential flow

struct FlowError {
  double l2, divergence;
};

/// A disc of radius a starts to move with the speed U in a round container of radius b: from rest the flow is that of
///   phi = -U a^2 / (b^2 - a^2) (r + b^2 / r) cos(theta),
/// so that u_r = U cos(theta) on the disc and 0 on the container. Relative to U.
FlowError annulus(int cells) {
  const double a = 0.16, b = 0.43, U = 0.7;
  Settings s = weightless(cells);
  s.fluid.surface = Surface::full;
  const std::vector<Obstacle> obstacles{{make_ball(at(0.5, 0.5), a), steady({U, 0, 0})},
                                        {complement(make_ball(at(0.5, 0.5), b))}};
  Flow<2> flow(s, seed_around<2>(s, obstacles, everywhere<2>), 1, obstacles);
  flow.solver.step(1e-11); // the open faces are those of the end of the step
  const auto& state = flow.state();
  double sum = 0;
  int count = 0;
  for (int c = 0; c < 2; ++c)
    each_in(state.grid, faces_of(state.grid, c), [&](const Index<2>& i, std::size_t where) {
      if (state.walls.open[static_cast<std::size_t>(c)][where] < 1) return;
      const double x = state.grid.dx * (i[0] - 2 + (c == 0 ? 0 : 0.5)) - 0.5;
      const double y = state.grid.dx * (i[1] - 2 + (c == 1 ? 0 : 0.5)) - 0.5;
      const double r2 = x * x + y * y, A = -U * a * a / (b * b - a * a);
      const double exact =
          c == 0 ? A * (1 + b * b / r2 - 2 * b * b * x * x / (r2 * r2)) : -A * 2 * b * b * x * y / (r2 * r2);
      sum += std::pow(state.u[static_cast<std::size_t>(c)][where] - exact, 2);
      ++count;
    });
  return {std::sqrt(sum / count) / U, max_divergence(state) / U};
}

TEST(Annulus, FlowsAsThePotentialDoes) {
  const FlowError coarse = annulus(32), fine = annulus(64), finest = annulus(128);
  EXPECT_LT(fine.l2, 1e-3);
  EXPECT_LT(finest.l2, 3.2e-4);
  EXPECT_LT(finest.l2, coarse.l2 / 7); // order 1.4 and more in the mean, one at the walls
  EXPECT_LT(finest.divergence, 1e-6);
}

// === Volume

/// What the piston sweeps rises at the other side.
TEST(Piston, LiftsTheWaterThatItDisplaces) {
  Settings s = box({40, 40, 40}, 1.0 / 40);
  s.transfer.scheme = pic; // comes to rest
  s.pressure.tolerance = 1e-7;
  const auto push = scripted(
      [](double t) {
        return Point{0.1 * std::min(t, 2.0), 0, 0};
      },
      [](double) { return 0.0; }, {0, 0, 0});
  const std::vector<Obstacle> obstacles{{make_half_space(at(0.1, 0), at(1, 0)), push}};
  Flow<2> flow(s, seed_around<2>(s, obstacles, [](const auto& x) { return x[1] < 0.35; }), 1, obstacles);
  const auto height = [&] {
    double sum = 0;
    for (const double y : flow.particles().x[1]) sum += y;
    return 2 * sum / static_cast<double>(flow.particles().size());
  };
  EXPECT_NEAR(height(), 0.35, 0.01);
  flow.run_to(4);
  const double expected = 0.35 * 0.9 / 0.7;
  EXPECT_NEAR(height(), expected, 0.01 * expected);
  EXPECT_LT(deepest(flow), 0);
}

/// The velocity on both sides of an open piston in a periodic channel is that of the piston: nothing leaks around it.
TEST(Piston, TakesTheWholeChannelAlong) {
  Settings s = weightless(32);
  s.walls.axis[0] = Wall::periodic;
  s.fluid.surface = Surface::full;
  const std::vector<Obstacle> obstacles{{make_box(at(0.313, -1), at(0.418, 2)), steady({0.3, 0, 0})}};
  Flow<2> flow(s, seed_around<2>(s, obstacles, everywhere<2>), 1, obstacles);
  flow.run_to(1.5);
  EXPECT_LT(max_divergence(flow.state()), 1e-6);
  for (std::size_t p = 0; p < flow.particles().size(); ++p) {
    EXPECT_NEAR(flow.particles().v[0][p], 0.3, 1e-6);
    EXPECT_NEAR(flow.particles().v[1][p], 0, 1e-6);
  }
  EXPECT_LT(deepest(flow), 0);
}

// === Rotation

/// Angular momentum that is left of a fluid that turned once in a round container.
double after_a_turn(int cells, int scheme, Splitting splitting, bool no_slip = false) {
  Settings s = weightless(cells);
  s.fluid.surface = Surface::full;
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  s.pressure.tolerance = 1e-8;
  Obstacle container{complement(make_ball(at(0.5, 0.5), 0.43))};
  container.no_slip = no_slip;
  Particles<2, double> seeded = seed_around<2>(s, {container}, everywhere<2>);
  const double omega = 2 * std::numbers::pi;
  for (std::size_t p = 0; p < seeded.size(); ++p)
    seeded.set_velocity(p, omega * Vec<2, double>(0.5 - seeded.x[1][p], seeded.x[0][p] - 0.5));
  Flow<2> flow(s, seeded, 1, {container});
  const auto momentum = [&] { return totals(flow.state(), flow.pool).angular_momentum[0]; };
  const double before = momentum();
  flow.run_to(1);
  EXPECT_LT(deepest(flow), 0);
  return momentum() / before;
}

TEST(RoundContainer, KeepsTheAngularMomentumOfARotation) {
  for (const int scheme : {flip, rpic, apic, aflip}) {
    EXPECT_NEAR(after_a_turn(32, scheme, Splitting::midpoint), 1, 0.04) << scheme_names[scheme];
    // First-order splitting alone costs (omega dt)^2 / 2 a step.
    EXPECT_NEAR(after_a_turn(32, scheme, Splitting::lie), 0.9, 0.05) << scheme_names[scheme];
  }
  EXPECT_NEAR(after_a_turn(64, apic, Splitting::midpoint), 1, 0.005);
  EXPECT_LT(after_a_turn(32, apic, Splitting::midpoint, true), 0.95) << "friction";
}

/// A turning container takes the fluid along where it sticks, and only there: its wall moves along itself.
TEST(RoundContainer, TakesStickyFluidAlong) {
  struct Stirred {
    double momentum, speed; ///< relative to those of a rigid rotation
  };
  const auto spun_up = [](bool no_slip) {
    const double omega = 3, radius = 0.43;
    Settings s = weightless(32);
    s.fluid.surface = Surface::full;
    s.transfer.scheme = pic;
    Obstacle container{complement(make_ball(at(0.5, 0.5), radius)), spinning(omega, middle), no_slip};
    Flow<2> flow(s, seed_around<2>(s, {container}, everywhere<2>), 1, {container});
    flow.run_to(2);
    const double rigid = omega * s.fluid.density * std::numbers::pi * std::pow(radius, 4) / 2;
    return Stirred{totals(flow.state(), flow.pool).angular_momentum[0] / rigid, flow.max_speed() / (omega * radius)};
  };
  EXPECT_GT(spun_up(true).momentum, 0.3);
  EXPECT_LT(spun_up(true).momentum, 1);
  EXPECT_NEAR(spun_up(false).momentum, 0, 0.01);
  EXPECT_LT(spun_up(false).speed, 0.015);
}

// === Particles

template <int Dim> std::vector<Obstacle> clutter() {
  return {{make_union({make_ball(at(0.3, 0.3), 0.15), make_ball(at(0.42, 0.34), 0.12)})},
          {make_difference({make_box(at(0.6, 0.1), at(0.9, 0.45)), make_ball(at(0.75, 0.45), 0.12)})},
          {make_capsule(at(0.2, 0.7), at(0.5, 0.85), 0.07)},
          {make_half_space(at(0.9, 0.9), at(-1, -1.3))},
          {make_box(at(0.6, 0.6), at(0.8, 0.7)), spinning(1, middle)}};
}

template <int Dim, class Real> void expect_all_outside() {
  Settings s = box({32, 32, 32}, 1.0 / 32, Dim);
  s.precision = sizeof(Real) == 4 ? Precision::single : Precision::double_;
  Particles<Dim, Real> particles;
  for (std::uint32_t p = 0; p < 100000; ++p) {
    Vec<Dim, Real> x;
    for (int d = 0; d < Dim; ++d) x[d] = static_cast<Real>(uniform(7, p, static_cast<unsigned>(d)));
    particles.add(x, Vec<Dim, Real>::Zero(), 1, p);
  }
  Flow<Dim, Real> flow(s, particles, 1, clutter<Dim>());
  int moved = 0;
  double furthest = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const auto x = flow.particles().position(p);
    const auto from = particles.position(flow.particles().id[p]);
    EXPECT_GE(flow.state().solids.distance(x.template cast<double>()), 0);
    for (int d = 0; d < Dim; ++d) {
      EXPECT_GE(x[d], 0);
      EXPECT_LT(x[d], 1);
    }
    moved += x != from;
    furthest = std::max(furthest, static_cast<double>((x - from).norm()));
  }
  EXPECT_GT(moved, 10000);
  EXPECT_LT(moved, 60000);
  EXPECT_LT(furthest, 0.3); // no farther than the middle of an obstacle from its surface
}

TEST(PushOut, LeavesNoParticleInside) {
  expect_all_outside<2, double>();
  expect_all_outside<2, float>();
  expect_all_outside<3, float>();
}

/// A stone thrown at an obstacle keeps what of its velocity is along the surface, and takes that of the obstacle
/// across.
TEST(PushOut, TakesTheVelocityIntoTheSolidOnly) {
  for (const double speed : {0.0, 0.4}) {
    Settings s = weightless(16);
    Particles<2, double> one;
    one.add({5.05 / 16, 10.9 / 16}, {1.3, 2}, 1, 0); // farther from its cell's centre than the radius
    const std::vector<Obstacle> wall{{make_half_space(at(0.5, 0.5), at(-1, -1)), steady({-speed, -speed, 0})}};
    Flow<2> flow(s, one, 1, wall);
    ASSERT_EQ(flow.state().ballistic[0], 1);
    flow.solver.step(0.01);
    EXPECT_NEAR(flow.particles().velocity(0)[0], -0.35 - speed, 1e-9);
    EXPECT_NEAR(flow.particles().velocity(0)[1], 0.35 - speed, 1e-9);
    EXPECT_NEAR(-deepest(flow), 1e-3 / 16, 1e-4 / 16);
  }
}

template <int Dim> void expect_clean_passage(int scheme, Splitting splitting, bool no_slip) {
  Settings s = box({40, 40, 20}, 1.0 / 40, Dim);
  if (Dim == 3) s = box({20, 20, 10}, 1.0 / 20, 3);
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  s.pressure.tolerance = 1e-5;
  Obstacle ball{make_ball(at(0.15, 0.6), 0.1),
                scripted(
                    [](double t) {
                      return Point{1.1 * t, -0.35 * std::sin(6 * t), 0};
                    },
                    [](double t) { return 10 * t; }, {0.2, 0.6, 0}),
                no_slip};
  Flow<Dim> flow(s, seed_around<Dim>(s, {ball}, [](const auto& x) { return x[1] < 0.4; }), 1, {ball});
  double depth = -1;
  while (flow.solver.time() < 0.6) {
    flow.solver.step(flow.solver.max_dt());
    depth = std::max(depth, deepest(flow));
  }
  EXPECT_LT(depth, 0);
  EXPECT_LT(flow.max_speed(), 12);
  EXPECT_GT(flow.max_speed(), 0.5);
}

TEST(MovingBall, CrossesAPoolWithoutATrace) {
  for (const int scheme : {flip, apic})
    for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection})
      expect_clean_passage<2>(scheme, splitting, scheme == apic);
  expect_clean_passage<3>(flip, Splitting::lie, false);
}

/// What is drawn stands where the obstacle is, with one surface for the whole run, and again across a periodic side.
TEST(MovingBall, IsPublished) {
  Settings s = weightless(16);
  s.walls.axis[0] = Wall::periodic;
  const std::vector<Obstacle> obstacles{{make_ball(at(0.5, 0.5), 0.1), steady({1, 0, 0})},
                                        {make_box(at(0.2, 0.1), at(0.3, 0.2))}};
  Flow<2> flow(s, seed_around<2>(s, obstacles, everywhere<2>), 1, obstacles);
  const auto first = flow.solver.snapshot(0, {});
  ASSERT_EQ(first->solids.size(), 2U);
  EXPECT_EQ(first->solids[1].pose.shift[0], 0);
  flow.run_to(0.5, 0.01);
  const auto later = flow.solver.snapshot(1, {});
  ASSERT_EQ(later->solids.size(), 3U) << "half of the ball on each side";
  for (const Solid& solid : later->solids) {
    ASSERT_FALSE(solid.surface->triangles.empty());
    EXPECT_EQ(solid.surface == first->solids[0].surface, solid.pose.shift[0] == 0) << "the box comes first";
  }
  EXPECT_NEAR(later->solids[1].pose.shift[0], -0.5, 1e-12);
  EXPECT_NEAR(later->solids[2].pose.shift[0], 0.5, 1e-12);
}

/// A ball on a periodic side is whole in both of its images.
template <int Dim> void expect_both_images() {
  Settings s = box({16, 16, 16}, 1.0 / 16, Dim);
  s.walls.axis[0] = Wall::periodic;
  const std::vector<Obstacle> obstacles{{make_ball(at(0, 0.5, 0.5), 0.2)}};
  Flow<Dim> flow(s, seed_around<Dim>(s, obstacles, everywhere<Dim>), 1, obstacles);
  const auto snapshot = flow.solver.snapshot(0, {});
  ASSERT_EQ(snapshot->solids.size(), 2U);
  EXPECT_EQ(snapshot->solids[0].pose.shift[0], 0);
  EXPECT_EQ(snapshot->solids[1].pose.shift[0], 1);
  EXPECT_EQ(snapshot->solids[0].id, snapshot->solids[1].id);
  const auto& vertices = snapshot->solids[0].surface->vertices;
  double lo = 1, hi = -1;
  for (std::size_t v = 0; v < vertices.size(); v += 3)
    lo = std::min<double>(lo, vertices[v]), hi = std::max<double>(hi, vertices[v]);
  EXPECT_NEAR(lo, -0.2, 1e-3);
  EXPECT_NEAR(hi, 0.2, 1e-3);
}

TEST(StillBall, IsPublishedOnBothSidesOfAPeriodicDomain) {
  expect_both_images<2>();
  expect_both_images<3>();
}

/// A still ball does not bound a step; a fast one does.
TEST(MovingBall, BoundsTheStep) {
  Settings s = weightless(32);
  const auto max_dt = [&](std::vector<Obstacle> obstacles) {
    return Flow<2>(s, seed<2>(s, everywhere<2>, at_rest<2>), 1, std::move(obstacles)).solver.max_dt();
  };
  EXPECT_GT(max_dt({{make_ball(at(0.5, 0.5), 0.1)}}), 1);
  EXPECT_NEAR(max_dt({{make_ball(at(0.5, 0.5), 0.1), steady({3, 4, 0})}}), 0.5 / 32 / 5, 1e-4);
  // The corner of its box is the fastest point that is looked at.
  EXPECT_NEAR(max_dt({{make_ball(at(0.5, 0.5), 0.1), spinning(10, middle)}}), 0.5 / 32 / (std::sqrt(2) * 1), 3e-4);
  // From far outside it must not pass in one step; far away it may do what it likes.
  EXPECT_LE(max_dt({{make_ball(at(-1, 0.5), 0.1), steady({100, 0, 0})}}), 1.0 / 100);
  EXPECT_GT(max_dt({{make_ball(at(-9, 0.5), 0.1), steady({-100, 0, 0})}}), 0.04);
  // Poses alone cannot tell 1000 radians per second from few.
  EXPECT_NEAR(max_dt({{make_ball(at(0.5, 0.5), 0.001), spinning(1000, middle)}}), 0.5 / 1000, 1e-5);
}

/// A formula can jump. Then the message names the obstacle.
TEST(MovingBall, ThatJumpsIsRefused) {
  const auto jump = scripted([](double t) { return Point{t < 0.01 ? 0 : 0.2, 0, 0}; }, [](double) { return 0.0; }, {});
  Flow<2> flow(weightless(32), seed<2>(weightless(32), everywhere<2>, at_rest<2>), 1,
               {{make_ball(at(0.2, 0.2), 0.1)}, {make_ball(at(0.5, 0.5), 0.1), jump}});
  std::string message;
  try {
    for (int i = 0; i < 2000 && flow.solver.time() < 0.02; ++i) flow.solver.step(flow.solver.max_dt());
  } catch (const UserError& error) {
    message = error.what();
  }
  EXPECT_EQ(message.substr(0, 58), "obstacle 2 of the scene jumps or moves too fast at t = 0.0");
}

/// Meshes are in world coordinates, and so must be what the fluid and the pictures take for their domain.
TEST(StillMesh, StandsWhereTheWorldHasIt) {
  Settings s = box({16, 16, 16}, 0.25, 3);
  s.grid.origin = {-2, -2, -2};
  s.fluid.gravity = {0, 0, 0};
  Mesh tetrahedron{{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const std::vector<Obstacle> obstacles{{make_mesh_shape(std::move(tetrahedron), false)}};
  Flow<3> flow(s, seed_around<3>(s, obstacles, everywhere<3>), 1, obstacles);
  EXPECT_LT(flow.state().solids.distance(Vec<3, double>(1.3, 1.3, 1.3)), 0);
  EXPECT_GT(flow.state().solids.distance(Vec<3, double>(0.3, 0.3, 0.3)), 1);
  const auto snapshot = flow.solver.snapshot(0, {});
  ASSERT_EQ(snapshot->solids.size(), 1U);
  EXPECT_EQ(snapshot->solids[0].surface->vertices[0], 1);
}

} // namespace
} // namespace flipbook::test
