// SPDX-License-Identifier: MIT
// Parameters that change during a run.
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

Flow<2> vortices(int scheme) {
  Settings s = periodic_box(32, 1);
  s.transfer.scheme = scheme;
  return Flow<2>(s, seed<2>(s, everywhere<2>, taylor_green));
}

/// Largest difference between C of the particles and the gradient of the exact vortices.
double gradient_error(const Particles<2, double>& particles) {
  const double k = 2 * std::numbers::pi;
  double worst = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double x = k * particles.x[0][p], y = k * particles.x[1][p];
    const std::array exact{k * std::cos(x) * std::cos(y), -k * std::sin(x) * std::sin(y), k * std::sin(x) * std::sin(y),
                           -k * std::cos(x) * std::cos(y)};
    for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, std::abs(particles.A[i][p] - exact[i]));
  }
  return worst / k;
}

TEST(Switching, StartsWithTheGradientOfTheFlow) {
  auto flow = vortices(apic);
  EXPECT_LT(gradient_error(flow.particles()), 0.15);
}

TEST(Switching, GathersTheAffineStateFromTheGrid) {
  auto flow = vortices(flip);
  flow.run_to(0.02, 0.005);
  EXPECT_TRUE(flow.particles().A.empty());
  EXPECT_TRUE(flow.solver.set("transfer.scheme", std::string("apic")).message.empty());
  EXPECT_EQ(flow.solver.title(), "APIC");
  EXPECT_LT(gradient_error(flow.particles()), 0.2);
  EXPECT_TRUE(flow.solver.set("transfer.scheme", std::string("rpic")).message.empty());
  EXPECT_EQ(flow.particles().A.size(), 1U);
  EXPECT_TRUE(flow.solver.set("transfer.scheme", std::string("pic")).message.empty());
  EXPECT_TRUE(flow.particles().A.empty());
}

TEST(Switching, KeepsTheKineticEnergy) {
  auto flow = vortices(pic);
  flow.run_to(0.02, 0.005);
  double before = kinetic_energy(flow.state(), flow.pool);
  for (const char* scheme : {"apic", "flip", "rpic", "aflip", "polypic", "xpic", "apic"}) {
    ASSERT_TRUE(flow.solver.set("transfer.scheme", std::string(scheme)).message.empty());
    flow.run_to(flow.solver.time() + 0.01, 0.005);
    const double after = kinetic_energy(flow.state(), flow.pool);
    EXPECT_GT(after, 0.9 * before) << scheme;
    EXPECT_LT(after, 1.05 * before) << scheme;
    before = after;
  }
}

TEST(Switching, AnotherKernelInMidRun) {
  auto flow = vortices(apic);
  flow.run_to(0.02, 0.005);
  const double before = kinetic_energy(flow.state(), flow.pool);
  ASSERT_TRUE(flow.solver.set("transfer.kernel", std::string("cubic")).message.empty());
  EXPECT_LT(gradient_error(flow.particles()), 0.2);
  flow.run_to(0.04, 0.005);
  EXPECT_NEAR(kinetic_energy(flow.state(), flow.pool) / before, 1, 0.1);
}

TEST(Switching, RefusesWhatNeedsARestartOrDoesNotExist) {
  auto flow = vortices(apic);
  EXPECT_NE(flow.solver.set("grid.cells", std::vector<double>{64, 64}).message.find("grid.cells"), std::string::npos);
  const Refusal r = flow.solver.set("transfer.schem", std::string("pic"));
  EXPECT_FALSE(r.message.empty());
  EXPECT_EQ(r.nearest, "transfer.scheme");
  EXPECT_FALSE(flow.solver.set("transfer.scheme", std::string("apix")).message.empty());
  EXPECT_EQ(flow.solver.title(), "APIC");
}

TEST(Switching, RefusesAToleranceThatSinglePrecisionCannotReach) {
  Settings s = box({8, 8, 8}, 1);
  s.precision = Precision::single;
  s.pressure.tolerance = 1e-6;
  Flow<2, float> flow(s, seed<2, float>(s, everywhere<2>, at_rest<2>));
  EXPECT_FALSE(flow.solver.set("pressure.tolerance", 1e-10).message.empty());
  EXPECT_TRUE(flow.solver.set("pressure.tolerance", 1e-5).message.empty());
}

TEST(Switching, ListsEveryParameterWithItsPresentValue) {
  auto flow = vortices(flip);
  ASSERT_TRUE(flow.solver.set("transfer.flip.flip_ratio", 0.5).message.empty() ||
              flow.solver.set("transfer.flip_ratio", 0.5).message.empty());
  EXPECT_EQ(flow.solver.title(), "FLIP 0.5");
  std::size_t found = 0;
  for (const Parameter& p : flow.solver.parameters())
    if (p.path.ends_with("flip_ratio") && p.applies) found += p.value == Value(0.5);
  EXPECT_EQ(found, 1U);
}

} // namespace
} // namespace flipbook::test
