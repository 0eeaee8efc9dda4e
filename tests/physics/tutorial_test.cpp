// SPDX-License-Identifier: MIT
// The fluid notes' algorithm against an oracle that shares no code with it.
#include "sim/core/random.h"
#include "sim/tutorial/tutorial_solver.h"
#include "tests/physics/tutorial_input.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flipbook::test {
namespace {

/// Largest distance of a coordinate from the oracle's; particle p of the run is order[p] of the oracle.
double distance(const Simulation& run, const TutorialOracle& oracle, const std::vector<std::size_t>& order) {
  const ParticleTable table = run.particle_table();
  double most = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t p = 0; p < order.size(); ++p)
      most = std::max(most, std::abs(table.columns[a].values[p] - oracle.particles[order[p]].x[a]));
  return most;
}

std::vector<std::size_t> file_order(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

double lowest(const TutorialOracle& oracle) {
  double z = 1;
  for (const OracleParticle& p : oracle.particles) z = std::min(z, p.x[2]);
  return z;
}

struct Case {
  const char* name;
  double flip_ratio;
  bool stir;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class AgainstTheOracle : public ::testing::TestWithParam<Case> {};

TEST_P(AgainstTheOracle, EveryParticleAgreesThroughTheImpact) {
  const ParticleRows rows = notes_block(GetParam().stir);
  TutorialOracle oracle = notes_oracle(rows, GetParam().flip_ratio);
  Running run(notes_scene(rows, GetParam().flip_ratio));
  const auto order = file_order(rows.size());
  const double floor = notes_lc[2] + notes_h + 1e-4;
  int impact = 0;
  for (int step = 1; step <= 150; ++step) {
    oracle.step();
    run.steps(1);
    ASSERT_LT(distance(*run.simulation, oracle, order), 1e-8) << "step " << step;
    if (impact == 0 && lowest(oracle) < floor + notes_h / 2) impact = step;
  }
  EXPECT_GT(impact, 10);
  EXPECT_LT(impact, 100) << "the block must hit the floor well before the last step";
  // What fell freely would be faster.
  EXPECT_LT(oracle.kinetic_energy(),
            0.8 * std::pow(9.80665 * notes_dt * 150, 2) / 2 * static_cast<double>(rows.size()));
}

const Case cases[] = {
    {"pic", 0, false}, {"flip095", 0.95, false}, {"flip1", 1, false}, {"flip095_stirred", 0.95, true}};
INSTANTIATE_TEST_SUITE_P(Each, AgainstTheOracle, ::testing::ValuesIn(cases),
                         [](const auto& c) { return std::string(c.param.name); });

TEST(Tutorial, HalfOfTheTestInputLiesOnFaces) {
  const ParticleRows rows = notes_block(false);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto on_face = std::count_if(rows.x.begin(), rows.x.end(), [&](const auto& x) {
      const double q = (x[a] - notes_lc[a]) / notes_h;
      return std::abs(q - std::round(q)) < 1e-9;
    });
    EXPECT_NEAR(static_cast<double>(on_face) / static_cast<double>(rows.size()), 0.5, 0.1);
  }
}

TEST(Tutorial, TheOrderOfTheParticlesIsOnlyRounding) {
  const ParticleRows rows = notes_block(true);
  std::vector<std::size_t> order = file_order(rows.size());
  for (std::size_t p = order.size(); p-- > 1;)
    std::swap(order[p], order[static_cast<std::size_t>(uniform(7, p, 0) * static_cast<double>(p + 1))]);
  ParticleRows shuffled;
  for (const std::size_t p : order) {
    shuffled.x.push_back(rows.x[p]);
    shuffled.v.push_back(rows.v[p]);
  }
  TutorialOracle oracle = notes_oracle(rows, 0.95);
  Running run(notes_scene(shuffled, 0.95));
  for (int step = 0; step < 150; ++step) oracle.step();
  run.steps(150);
  EXPECT_LT(distance(*run.simulation, oracle, order), 1e-8);
}

TEST(Tutorial, TheSameBitsForAnyNumberOfThreads) {
  const Scene scene = notes_scene(notes_block(true), 0.95);
  Running one(scene, 1), three(scene, 3);
  one.steps(60);
  three.steps(60);
  const ParticleTable a = one.simulation->particle_table(), b = three.simulation->particle_table();
  for (std::size_t c = 0; c < a.columns.size(); ++c) EXPECT_EQ(a.columns[c].values, b.columns[c].values);
}

TEST(Tutorial, ParticlesAreThoseOfTheFileInItsOrder) {
  const ParticleRows rows = notes_block(true);
  Running run(notes_scene(rows, 0.95));
  const ParticleTable table = run.simulation->particle_table();
  EXPECT_FALSE(table.single);
  ASSERT_EQ(table.columns.size(), 6U);
  EXPECT_EQ(table.columns[5].name, "vz");
  for (std::size_t p = 0; p < rows.size(); ++p) {
    EXPECT_EQ(table.id[p], p);
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_EQ(table.columns[a].values[p], rows.x[p][a]);
      EXPECT_EQ(table.columns[3 + a].values[p], rows.v[p][a]);
    }
  }
}

TEST(Tutorial, AParticleThrownAtAWallStopsBeforeTheSolidLayer) {
  ParticleRows rows;
  rows.x = {{0, 0, 0}};
  rows.v = {{100, -100, 100}};
  Running run(notes_scene(rows, 1));
  run.steps(1);
  const ParticleTable table = run.simulation->particle_table();
  const std::array<double, 3> expected{notes_lc[0] + 14 * notes_h - notes_h - 1e-4, notes_lc[1] + notes_h + 1e-4,
                                       notes_lc[2] + 16 * notes_h - notes_h - 1e-4};
  for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(table.columns[a].values[0], expected[a]);
}

TEST(Tutorial, TakesWholeStepsOfItsOwn) {
  Running run(notes_scene(notes_block(false), 0.95));
  EXPECT_EQ(run.simulation->fixed_dt(), notes_dt);
  EXPECT_EQ(run.simulation->max_dt(), notes_dt);
  EXPECT_THROW(run.simulation->step(notes_dt / 2), std::invalid_argument);
  run.steps(3);
  EXPECT_EQ(run.simulation->time(), 3 * notes_dt);
}

TEST(Tutorial, AParticleThatIsNoLongerFiniteIsReported) {
  ParticleRows rows = notes_block(false);
  for (auto& v : rows.v) v = {1e308, -1e308, 1e308};
  Running run(notes_scene(rows, 1));
  EXPECT_THROW(run.steps(3), NonFiniteError);
}

/// The quotient of size and cells is often not the number that the size was made from.
TEST(Tutorial, TheEdgeOfACellIsTheNumberThatWasWritten) {
  int missed = 0;
  for (const double h : {0.01, 0.02, 0.05, 0.1, 0.005, 0.025, 0.0125, 0.004, 0.03, 0.2, 0.001, 1.0, 7.5})
    for (int n = 3; n < 300; ++n) {
      GridSettings grid;
      grid.cells = {n, n + 1, 2 * n + 1};
      for (std::size_t a = 0; a < 3; ++a) grid.size[a] = grid.cells[a] * h;
      EXPECT_EQ(notes_cell_size(grid), h) << n;
      missed += grid.size[0] / grid.cells[0] != h ? 1 : 0;
    }
  EXPECT_GT(missed, 50) << "else a quotient would do";
}

/// Each frame shows the state after the first step that ends 1e-4 s short of the interval or later.
TEST(Tutorial, FramesFollowTheNotesRule) {
  EXPECT_EQ(notes_steps_per_frame(1.0 / 30, notes_dt), 30);
  EXPECT_EQ(notes_steps_per_frame(1.0 / 60, notes_dt), 15);
  EXPECT_EQ(notes_steps_per_frame(1.0 / 30, 1.0 / 30), 1);
  EXPECT_EQ(notes_steps_per_frame(1.0 / 30, 0.0333), 1);
  EXPECT_EQ(notes_steps_per_frame(1.0 / 30, 0.0332), 2);
  EXPECT_EQ(notes_steps_per_frame(1e-6, 1), 1);
}

} // namespace
} // namespace flipbook::test
