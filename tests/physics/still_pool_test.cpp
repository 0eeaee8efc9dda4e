// SPDX-License-Identifier: MIT
// A pool at rest stays at rest, and its pressure is hydrostatic below the surface that the solver itself found.
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

constexpr double depth = 0.5, gravity = 9.81, density = 1000;

template <int Dim>
Flow<Dim> pool(int cells, int scheme, KernelName kernel, Splitting splitting = Splitting::lie,
               Wall side = Wall::free_slip) {
  Settings s = box({cells, cells, cells}, 1.0 / cells, Dim);
  s.walls.axis = {side, side == Wall::periodic ? Wall::free_slip : side, side};
  s.transfer.scheme = scheme;
  s.transfer.kernel = kernel;
  s.time.splitting = splitting;
  return Flow<Dim>(s, seed<Dim>(
                          s, [](const auto& x) { return x[1] < depth; }, at_rest<Dim>));
}

/// Largest |p - rho g (y_s - y)| / (rho g depth), with the height y_s where the solver puts p = 0.
template <int Dim> double pressure_error(const Flow<Dim>& flow) {
  const auto& s = flow.state();
  double worst = 0;
  each_in(s.grid, cells_of(s.grid), [&](const Index<Dim>& i, std::size_t at) {
    if (!s.cells.fluid[at]) return;
    std::size_t top = at;
    int above = 0;
    for (; s.cells.fluid[top + static_cast<std::size_t>(s.grid.stride(1))]; ++above)
      top += static_cast<std::size_t>(s.grid.stride(1));
    const auto face = top + static_cast<std::size_t>(s.grid.stride(1));
    const double depth_here = s.grid.dx * (above + 1 / s.cells.inverse_theta[1][face]);
    worst = std::max(worst, std::abs(s.p[at] / (density * gravity) - depth_here));
    EXPECT_NEAR(s.grid.dx * (i[1] - 1.5) + depth_here, depth, 1e-9); // the radius puts the surface where the water ends
  });
  return worst / depth;
}

class StillPool : public testing::TestWithParam<std::tuple<int, KernelName>> {};

TEST_P(StillPool, StaysStill) {
  const auto [scheme, kernel] = GetParam();
  for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
    auto flow = pool<2>(32, scheme, kernel, splitting);
    flow.run_to(1.5);
    EXPECT_LT(flow.max_speed(), 1e-6);
    EXPECT_LT(pressure_error(flow), 1e-6);
    EXPECT_GT(flow.solver.steps(), 30U);
  }
}

INSTANTIATE_TEST_SUITE_P(All, StillPool,
                         testing::Combine(testing::Range(0, 5),
                                          testing::Values(KernelName::linear, KernelName::quadratic,
                                                          KernelName::cubic)),
                         [](const auto& run) {
                           return std::string(scheme_names[std::get<0>(run.param)]) + "_" +
                                  std::string(kernel_options()[static_cast<std::size_t>(std::get<1>(run.param))].name);
                         });

template <int Dim> void stays_still_beside(Wall side, KernelName kernel) {
  auto flow = pool<Dim>(Dim == 2 ? 16 : 8, apic, kernel, Splitting::lie, side);
  flow.run_to(1);
  EXPECT_LT(flow.max_speed(), 1e-6);
  EXPECT_LT(pressure_error(flow), 1e-6);
}

class StillPoolWalls : public testing::TestWithParam<std::tuple<Wall, KernelName>> {};

TEST_P(StillPoolWalls, StaysStill) {
  const auto [side, kernel] = GetParam();
  stays_still_beside<2>(side, kernel);
  stays_still_beside<3>(side, kernel);
}

INSTANTIATE_TEST_SUITE_P(All, StillPoolWalls,
                         testing::Combine(testing::Values(Wall::free_slip, Wall::no_slip, Wall::periodic),
                                          testing::Values(KernelName::linear, KernelName::quadratic,
                                                          KernelName::cubic)));

TEST(StillPool, VoxelSurfaceLiesHalfACellTooHigh) {
  Settings s = box({16, 16, 16}, 1.0 / 16);
  s.fluid.surface = Surface::voxel;
  Flow<2> flow(s, seed<2>(
                      s, [](const auto& x) { return x[1] < depth; }, at_rest<2>));
  flow.run_to(0.2);
  const auto bottom = static_cast<std::size_t>(flow.state().grid.at({8, 2}));
  EXPECT_NEAR(flow.state().p[bottom], density * gravity * depth, 1e-6 * density * gravity); // h - dx/2 + dx/2
}

} // namespace
} // namespace flipbook::test
