// SPDX-License-Identifier: MIT
#include "sim/fluid/advect.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

#include <complex>

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

} // namespace
} // namespace flipbook::test
