// SPDX-License-Identifier: MIT
// Taylor-Green vortices show what each scheme costs: the exact flow is steady and keeps its energy.
#include "sim/transfer/schemes.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

constexpr double pi = std::numbers::pi;

/// The share of the kinetic energy that is left at `time`, on the grid.
double energy_left(int cells, double cfl, double time, int scheme, double flip_ratio = 1,
                   Splitting splitting = Splitting::lie, KernelName kernel = KernelName::linear) {
  Settings s = periodic_box(cells, 1);
  s.seeding.pattern = Pattern::jittered;
  s.transfer.scheme = scheme;
  s.transfer.kernel = kernel;
  scheme_of<Flip>(s.transfer).flip_ratio = flip_ratio;
  s.time.splitting = splitting;
  s.pressure.tolerance = 1e-8;
  Flow<2> flow(s, seed<2>(s, everywhere<2>, taylor_green));
  flow.run_to(time, cfl / cells);
  return flow.grid_energy() / (s.fluid.density / 4);
}

TEST(TaylorGreen, SchemesLoseEnergyInTheKnownOrder) {
  const double of_pic = energy_left(48, 0.25, 1, pic), of_rpic = energy_left(48, 0.25, 1, rpic);
  const double of_flip = energy_left(48, 0.25, 1, flip, 0.95), of_apic = energy_left(48, 0.25, 1, apic);
  EXPECT_LT(of_pic, 0.9 * of_rpic);
  EXPECT_LT(of_rpic, 0.9 * of_flip);
  EXPECT_LT(of_flip, of_apic);
  EXPECT_LT(of_apic, 1);
}

TEST(TaylorGreen, ReflectingSplittingsLoseLess) {
  for (const int scheme : {flip, apic}) {
    const double lie = energy_left(32, 0.5, 1, scheme);
    for (const Splitting splitting : {Splitting::midpoint, Splitting::reflection}) {
      const double left = energy_left(32, 0.5, 1, scheme, 1, splitting);
      EXPECT_LT(1 - left, 0.5 * (1 - lie)) << scheme_names[scheme];
      EXPECT_LT(left, 1.01) << scheme_names[scheme];
    }
  }
}

/// PolyPIC's transfers lose next to nothing, so what depends on dt is the splitting's: of first order for one thing
/// after the other, of a higher one for a reflection.
TEST(TaylorGreen, LossFollowsTheOrderOfTheSplitting) {
  struct Steps {
    double coarse, fine; ///< what halving dt saves, from CFL 1 and from CFL 1/2
  };
  const auto saved = [](Splitting splitting) {
    const auto left = [&](double cfl) { return energy_left(32, cfl, 0.5, polypic, 1, splitting); };
    const double half = left(0.5);
    return Steps{half - left(1), left(0.25) - half};
  };
  const Steps lie = saved(Splitting::lie);
  EXPECT_NEAR(lie.fine / lie.coarse, 0.5, 0.2);
  for (const Splitting splitting : {Splitting::midpoint, Splitting::reflection}) {
    const Steps steps = saved(splitting);
    EXPECT_LT(std::abs(steps.coarse), 0.15 * lie.coarse);
    EXPECT_LT(std::abs(steps.fine), 0.3 * std::abs(steps.coarse));
  }
}

/// PIC convolves the velocity with the kernel twice a step, variance D each on the average over the cell: nu = D / dt.
TEST(TaylorGreen, PicHasTheViscosityOfItsKernel) {
  constexpr double time = 0.05, cfl = 1.0 / 16;
  constexpr int cells = 64;
  const auto nu = [&](KernelName kernel, Splitting splitting) {
    return -std::log(energy_left(cells, cfl, time, pic, 1, splitting, kernel)) / (16 * pi * pi * time);
  };
  const double dx = 1.0 / cells, dt = cfl * dx, unit = dx * dx / dt;
  EXPECT_NEAR(nu(KernelName::linear, Splitting::lie) / unit, 1.0 / 6, 0.01);
  EXPECT_NEAR(nu(KernelName::quadratic, Splitting::lie) / unit, 1.0 / 4, 0.015);
  EXPECT_NEAR(nu(KernelName::linear, Splitting::midpoint) / unit, 1.0 / 6, 0.01);
  EXPECT_NEAR(nu(KernelName::linear, Splitting::reflection) / unit, 1.0 / 6, 0.01);
}

TEST(TaylorGreen, PressureIsTheExactOne) {
  for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection}) {
    Settings s = periodic_box(64, 1);
    s.time.splitting = splitting;
    Flow<2> flow(s, seed<2>(s, everywhere<2>, taylor_green));
    flow.run_to(0.01, 0.001);
    const auto& state = flow.state();
    double worst = 0;
    each_in(state.grid, cells_of(state.grid), [&](const Index<2>& i, std::size_t at) {
      const double x = (i[0] - 1.5) / 64, y = (i[1] - 1.5) / 64;
      const double exact = s.fluid.density / 4 * (std::cos(4 * pi * x) + std::cos(4 * pi * y));
      worst = std::max(worst, std::abs(state.p[at] - exact));
    });
    EXPECT_LT(worst, 0.05 * s.fluid.density / 2);
  }
}

} // namespace
} // namespace flipbook::test
