// SPDX-License-Identifier: MIT
// A disc of liquid that is stretched with v = A0 (x, -y), without gravity or walls, stays an ellipse with the semi-axes
// a and 1/a, where a' = a A and A = A0 sqrt(2 / (a^2 + a^-2)); its kinetic energy is constant [Monaghan 1994].
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

constexpr double radius = 1, rate = 1, half_width = 2.5, half_height = 1.5;

/// a(t), by the classic Runge-Kutta method.
double exact_axis(double time) {
  double a = radius;
  constexpr int steps = 1000;
  const double h = time / steps;
  const auto slope = [](double x) { return x * rate * std::sqrt(2 / (x * x + 1 / (x * x))); };
  for (int i = 0; i < steps; ++i) {
    const double k1 = slope(a), k2 = slope(a + h / 2 * k1), k3 = slope(a + h / 2 * k2), k4 = slope(a + h * k3);
    a += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return a;
}

Flow<2> drop(int scheme, Splitting splitting) {
  Settings s = box({160, 96, 1}, radius / 32);
  s.fluid.gravity = {0, 0, 0};
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  s.pressure.tolerance = 1e-8;
  const Vec<2, double> centre(half_width, half_height);
  return Flow<2>(
      s, seed<2>(
             s, [&](const auto& x) { return (x - centre).norm() < radius; },
             [&](const auto& x) { return Vec<2, double>(rate * (x[0] - centre[0]), -rate * (x[1] - centre[1])); }));
}

/// Semi-axes of the ellipse with the same second moments.
std::array<double, 2> axes(const Particles<2, double>& particles) {
  std::array<double, 2> result{};
  for (std::size_t d = 0; d < 2; ++d) {
    double mean = 0, square = 0;
    for (const double x : particles.x[d]) mean += x / static_cast<double>(particles.size());
    for (const double x : particles.x[d]) square += (x - mean) * (x - mean) / static_cast<double>(particles.size());
    result[d] = 2 * std::sqrt(square);
  }
  return result;
}

class EllipticalDrop : public testing::TestWithParam<std::tuple<int, Splitting>> {};

TEST_P(EllipticalDrop, KeepsItsExactAxesAndItsEnergy) {
  auto flow = drop(std::get<0>(GetParam()), std::get<1>(GetParam()));
  const double before = kinetic_energy(flow.state(), flow.pool);
  EXPECT_NEAR(exact_axis(1), 2.275516, 1e-6);   // the exact solution's table
  const auto [x0, y0] = axes(flow.particles()); // 0.1 % above 1: a disc of squares
  flow.run_to(1);
  const auto [x, y] = axes(flow.particles());
  EXPECT_NEAR(x / (x0 * exact_axis(1)), 1, 0.002);
  EXPECT_NEAR(y / (y0 / exact_axis(1)), 1, 0.01);
  const double kept = kinetic_energy(flow.state(), flow.pool) / before;
  EXPECT_GT(kept, 0.985);
  EXPECT_LT(kept, 1.005);
}

INSTANTIATE_TEST_SUITE_P(All, EllipticalDrop,
                         testing::Combine(testing::Values(flip, apic),
                                          testing::Values(Splitting::lie, Splitting::midpoint, Splitting::reflection)),
                         [](const auto& run) {
                           return std::string(scheme_names[std::get<0>(run.param)]) + "_" +
                                  splitting_names[static_cast<std::size_t>(std::get<1>(run.param))];
                         });

} // namespace
} // namespace flipbook::test
