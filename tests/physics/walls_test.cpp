// SPDX-License-Identifier: MIT
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

/// Particles everywhere, thrown at every wall and corner.
template <int Dim> Particles<Dim, double> thrown(const Settings& s) {
  return seed<Dim>(
      s,
      [](const auto& x) {
        return uniform(1, static_cast<std::uint64_t>(1e7 * x[0]), static_cast<std::uint64_t>(1e7 * x[1])) < 0.4;
      },
      [](const auto& x) {
        Vec<Dim, double> v;
        for (int d = 0; d < Dim; ++d)
          v[d] = 40 * (uniform(2, static_cast<std::uint64_t>(1e7 * x[d]), static_cast<std::uint64_t>(d)) - 0.5);
        return v;
      });
}

template <int Dim> void expect_inside(const std::array<Wall, 3>& walls, int scheme, Splitting splitting) {
  Settings s = box({10, 12, 8}, 0.1, Dim);
  s.seeding.pattern = Pattern::jittered;
  s.walls.axis = walls;
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  s.time.cfl = 2;
  s.pressure.tolerance = 1e-6;
  Flow<Dim> flow(s, thrown<Dim>(s));
  for (int i = 0; i < 40; ++i) flow.solver.step(flow.solver.max_dt());
  for (std::size_t p = 0; p < flow.particles().size(); ++p)
    for (int d = 0; d < Dim; ++d) {
      const double x = flow.particles().position(p)[d];
      ASSERT_GE(x, 0);
      ASSERT_LT(x, s.grid.size[static_cast<std::size_t>(d)]);
    }
}

TEST(Walls, NoParticleLeavesTheDomain) {
  constexpr Wall slip = Wall::free_slip, stick = Wall::no_slip, wrap = Wall::periodic;
  for (const auto& walls : {std::array{slip, slip, slip}, std::array{stick, stick, stick}, std::array{wrap, wrap, wrap},
                            std::array{wrap, slip, stick}, std::array{stick, wrap, slip}})
    for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
      expect_inside<2>(walls, flip, splitting);
      expect_inside<3>(walls, apic, splitting);
    }
}

TEST(Walls, FoldKeepsEverySum) {
  for (const int n : {2, 4, 6}) { // the pads of two cells hold one of them more than once
    SCOPED_TRACE(n);
    Settings s = periodic_box(n, 1);
    s.walls.axis = {Wall::periodic, Wall::free_slip, Wall::free_slip};
    const auto grid = grid_of<2>(s);
    const Walls<2, double> walls(grid, s.walls);
    Field<double> f(static_cast<std::size_t>(grid.size()));
    double all = 0;
    for (std::size_t i = 0; i < f.size(); ++i) all += f[i] = uniform(3, i, 0);
    walls.fold(f);
    double one_period = 0;
    each_in(grid, Box<2>{{2, 0}, {2 + n, grid.extent()[1]}}, [&](const auto&, std::size_t at) { one_period += f[at]; });
    EXPECT_NEAR(one_period, all, 1e-12 * all);
    each_in(grid, all_of(grid), [&](const Index<2>& i, std::size_t at) {
      EXPECT_EQ(f[at], f[static_cast<std::size_t>(grid.at(walls.image(i)))]);
    });
  }
}

/// u in the pads next to the lower y wall, over u beside it.
double tangential_ratio(Wall wall, double u_wall) {
  Settings s = box({8, 8, 8}, 1);
  s.walls.axis = {Wall::free_slip, wall, Wall::free_slip};
  const auto grid = grid_of<2>(s);
  Walls<2, double> walls(grid, s.walls);
  std::fill(walls.u_solid[0].begin(), walls.u_solid[0].end(), u_wall);
  Components<2, double> u;
  u.resize(grid);
  each_in(grid, faces_of(grid, 0), [&](const Index<2>& i, std::size_t at) { u[0][at] = 3 + i[1]; });
  walls.pad(u);
  const auto beside = static_cast<std::size_t>(grid.at({5, 2})), outside = static_cast<std::size_t>(grid.at({5, 1}));
  EXPECT_EQ(u[0][beside], 5);
  return u[0][outside];
}

TEST(Walls, SlipContinuesTheTangentialVelocityAndFrictionTakesIt) {
  EXPECT_EQ(tangential_ratio(Wall::free_slip, 0), 5);
  EXPECT_EQ(tangential_ratio(Wall::no_slip, 0), 0);
  EXPECT_EQ(tangential_ratio(Wall::no_slip, 2), 2);
  EXPECT_EQ(tangential_ratio(Wall::periodic, 0), 12); // the row below the upper side
}

TEST(Walls, NothingFlowsThroughThem) {
  Settings s = box({16, 16, 16}, 1.0 / 16);
  Flow<2> flow(s, seed<2>(
                      s, [](const auto& x) { return x[0] < 0.4; }, at_rest<2>));
  flow.run_to(0.5);
  const auto& state = flow.state();
  for (int a = 0; a < 2; ++a)
    each_in(state.grid, all_of(state.grid), [&](const Index<2>& i, std::size_t at) {
      if (i[a] <= 2 || i[a] >= 18) {
        EXPECT_EQ(state.u[static_cast<std::size_t>(a)][at], 0);
      }
    });
}

TEST(Walls, FrictionSlowsAChannelAndSlipDoesNot) {
  const auto speed_after = [](Wall wall) {
    Settings s = periodic_box(16, 1);
    s.walls.axis[1] = wall;
    s.transfer.scheme = pic; // its viscosity carries the friction inwards
    Flow<2> flow(s, seed<2>(s, everywhere<2>, [](const auto&) { return Vec<2, double>(1, 0); }));
    flow.run_to(0.2, 0.01);
    return kinetic_energy(flow.state(), flow.pool) / (s.fluid.density / 2);
  };
  EXPECT_NEAR(speed_after(Wall::free_slip), 1, 1e-9);
  EXPECT_LT(speed_after(Wall::no_slip), 0.9);
}

} // namespace
} // namespace flipbook::test
