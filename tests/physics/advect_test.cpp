// SPDX-License-Identifier: MIT
#include "sim/fluid/advect.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace flipbook::test {
namespace {

/// On u = omega x (x - c), which every kernel reproduces, a Runge-Kutta step of order n <= 3 turns x - c by exactly the
/// first n + 1 terms of exp(i omega dt): any other coefficient in any stage changes one of them.
TEST(Advect, TurnsByTheSeriesOfItsOrder) {
  const Settings s = box({10, 10, 10}, 0.1);
  const auto grid = grid_of<2>(s);
  const Walls<2, double> walls(grid, s.walls);
  constexpr double omega = 3, dt = 0.2;
  Components<2, double> u;
  u.resize(grid);
  for (int a = 0; a < 2; ++a)
    each_in(grid, all_of(grid), [&](const Index<2>& i, std::size_t at) {
      const Vec<2, double> x =
          grid.dx * (i.cast<double>() - Vec<2, double>::Constant(2) + component_origin<2, double>(Layout::mac, a));
      u[static_cast<std::size_t>(a)][at] = a == 0 ? -omega * (x[1] - 0.5) : omega * (x[0] - 0.5);
    });
  Budget budget{1};
  Pool pool{budget};
  const Budget::Permit permit{budget};
  const std::complex<double> centre(0.5, 0.5), start(0.63, 0.58), turn(0, omega * dt);
  std::complex<double> series = 1, term = 1;
  int n = 0;
  for (const Advection method : {Advection::rk1, Advection::rk2, Advection::rk3}) {
    term *= turn / static_cast<double>(++n);
    series += term;
    for (const KernelName kernel : {KernelName::linear, KernelName::quadratic, KernelName::cubic}) {
      Particles<2, double> one;
      one.add({start.real(), start.imag()}, {0, 0}, 1, 0);
      advect(method, kernel, grid, walls, u, dt, {0}, one, pool);
      const std::complex<double> end = centre + series * (start - centre);
      EXPECT_NEAR(one.x[0][0], end.real(), 1e-14) << n;
      EXPECT_NEAR(one.x[1][0], end.imag(), 1e-14) << n;
    }
  }
}

/// More particles than a pack has lanes, some of them ballistic, thrown by a uniform flow far beyond every side: walls
/// stop them, periodic sides bring them in from the other end.
template <int Dim, class Real> void expect_inside(Wall wall) {
  Settings s = box({10, 10, 10}, 0.1);
  s.walls.axis.fill(wall);
  const auto grid = grid_of<Dim>(s);
  const Walls<Dim, Real> walls(grid, s.walls);
  Budget budget{1};
  Pool pool{budget};
  const Budget::Permit permit{budget};
  for (const Real speed : {Real(0.7), Real(-0.7)}) {
    Components<Dim, Real> u;
    u.resize(grid);
    for (auto& f : u) std::fill(f.begin(), f.end(), speed);
    Particles<Dim, Real> many;
    std::vector<std::uint8_t> ballistic;
    for (std::uint32_t i = 0; i < 21; ++i) {
      many.add(Vec<Dim, Real>::Constant(Real(0.04 + 0.04 * i)), Vec<Dim, Real>::Constant(speed), 1, i);
      ballistic.push_back(i % 5 == 3);
    }
    const auto start = many.x[0];
    EXPECT_EQ(advect(Advection::rk3, KernelName::quadratic, grid, walls, u, 1, ballistic, many, pool),
              wall != Wall::periodic);
    for (std::size_t d = 0; d < Dim; ++d)
      for (std::size_t p = 0; p < many.size(); ++p) {
        const Real free = start[p] + speed, gap = Real(0.1) * Real(Walls<Dim, Real>::gap);
        const Real expected = wall == Wall::periodic ? free - std::floor(free) : std::clamp(free, gap, 1 - gap);
        EXPECT_NEAR(many.x[d][p], expected, 4 * std::numeric_limits<Real>::epsilon()) << p;
        EXPECT_EQ(many.v[d][p], ballistic[p] && wall != Wall::periodic && free != expected ? 0 : speed) << p;
      }
  }
}
TEST(Advect, EndsInTheDomain) {
  for (const Wall wall : {Wall::free_slip, Wall::periodic}) {
    expect_inside<2, float>(wall);
    expect_inside<2, double>(wall);
    expect_inside<3, float>(wall);
    expect_inside<3, double>(wall);
  }
}

/// A particle that stopped being finite is looked up nowhere and stays what it is, to be reported; its neighbours move.
TEST(Advect, LeavesWhatIsNotFiniteToBeReported) {
  const Settings s = box({10, 10, 10}, 0.1);
  const auto grid = grid_of<3>(s);
  const Walls<3, float> walls(grid, s.walls);
  Components<3, float> u;
  u.resize(grid);
  for (auto& f : u) std::fill(f.begin(), f.end(), std::numeric_limits<float>::quiet_NaN());
  Budget budget{1};
  Pool pool{budget};
  const Budget::Permit permit{budget};
  Particles<3, float> one;
  one.add({0.5F, 0.5F, 0.5F}, {0, 0, 0}, 1, 0);
  advect(Advection::rk3, KernelName::cubic, grid, walls, u, 0.1, {0}, one, pool);
  EXPECT_TRUE(std::isnan(one.x[0][0]));
}

} // namespace
} // namespace flipbook::test
