// SPDX-License-Identifier: MIT
// From a scene to a simulation that runs.
#include "sim/boundary/shape.h"
#include "sim/scene/scene.h"
#include "sim/scene/velocity.h"
#include "sim/simulation.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

Scene column(int dim, Precision precision) {
  Scene scene;
  scene.settings = box({12, 12, 12}, 1.0 / 12, dim);
  scene.settings.precision = precision;
  scene.settings.pressure.tolerance = 1e-6;
  scene.fluid.push_back({make_box({{0, 0, 0}, 3}, {{0.4, 0.6, 1}, 3}), components_velocity({0, 0, 0}, {})});
  return scene;
}

std::string refusal(const Scene& scene) {
  Budget budget(1);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  try {
    (void)make_simulation(scene, pool);
  } catch (const UserError& e) {
    return e.what();
  }
  return "";
}

TEST(MakeSimulation, RunsInEveryDimensionAndPrecision) {
  Budget budget(2);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  for (const int dim : {2, 3})
    for (const Precision precision : {Precision::single, Precision::double_}) {
      const auto simulation = make_simulation(column(dim, precision), pool);
      const std::size_t expected = dim == 2 ? 10 * 14 : 10 * 14 * 24; // ceil(0.4 * 24), ceil(0.6 * 24) regular places
      EXPECT_EQ(simulation->particles(), expected);
      for (int i = 0; i < 10; ++i) simulation->step(simulation->max_dt());
      EXPECT_EQ(simulation->steps(), 10U);
      const auto s = simulation->snapshot(1, {{"speed"}, true, true, true});
      EXPECT_EQ(s->dim, dim);
      EXPECT_EQ(s->lattices.size(), static_cast<std::size_t>(dim + 2));
      EXPECT_GT(s->channels[0].hi, 0.1);
      EXPECT_LT(s->channels[0].hi, 5);
    }
}

TEST(MakeSimulation, RefusesScenesThatCannotRun) {
  EXPECT_EQ(refusal(column(2, Precision::single)), "");

  Scene too_precise = column(2, Precision::single);
  too_precise.settings.pressure.tolerance = 1e-10;
  EXPECT_NE(refusal(too_precise).find("single precision"), std::string::npos);

  Scene oblong = column(2, Precision::double_);
  oblong.settings.grid.size[1] = 2;
  EXPECT_NE(refusal(oblong).find("cubic"), std::string::npos);

  Scene odd = column(2, Precision::double_);
  odd.settings.grid = {{11, 11, 11}, {1, 1, 1}};
  odd.settings.walls.axis[0] = Wall::periodic;
  EXPECT_NE(refusal(odd).find("even"), std::string::npos);

  Scene narrow = column(2, Precision::double_);
  narrow.settings.grid = {{2, 12, 12}, {1.0 / 6, 1, 1}};
  narrow.settings.walls.axis[0] = Wall::periodic;
  EXPECT_NE(refusal(narrow).find("at least 4"), std::string::npos);

  Scene huge = column(3, Precision::single);
  huge.settings.grid = {{16384, 16384, 16384}, {1, 1, 1}};
  EXPECT_NE(refusal(huge).find("cells"), std::string::npos);

  Scene empty = column(2, Precision::single);
  empty.fluid.clear();
  EXPECT_NE(refusal(empty), "");
}

} // namespace
} // namespace flipbook::test
