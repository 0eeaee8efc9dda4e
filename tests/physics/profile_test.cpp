// SPDX-License-Identifier: MIT
// Where the time goes: every part of a step is told apart, and looking changes nothing.
#include "sim/boundary/shape.h"
#include "sim/scene/scene.h"
#include "sim/scene/velocity.h"
#include "sim/simulation.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

Scene column(int dim) {
  Scene scene;
  scene.settings = box({12, 12, 12}, 1.0 / 12, dim);
  scene.settings.ledger.on = true;
  scene.fluid.push_back({make_box({{0, 0, 0}, 3}, {{0.4, 0.6, 1}, 3}), components_velocity({0, 0, 0}, {})});
  return scene;
}

const Profile::Spent& spent(const Profile& p, Phase phase) {
  return p.spent[static_cast<std::size_t>(phase)];
}

TEST(Profile, AScopeGoesBackToThePhaseAroundIt) {
  Profile p;
  {
    const Timed outer(&p, Phase::advect);
    {
      Timed inner(&p, Phase::sort);
      inner.turn(Phase::p2g);
      EXPECT_EQ(p.turn(Phase::p2g), Phase::p2g);
    }
    EXPECT_EQ(p.turn(Phase::advect), Phase::advect);
  }
  EXPECT_EQ(p.turn(Phase::outside), Phase::outside);
  EXPECT_GT(spent(p, Phase::advect).wall, 0);
  EXPECT_EQ(spent(p, Phase::outside).wall, 0) << "what lies outside is nobody's time";
}

TEST(Profile, TellsEveryPartOfAStepApart) {
  Budget budget(2);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  for (const int dim : {2, 3}) {
    const auto simulation = make_simulation(column(dim), pool);
    Profile p;
    simulation->profile(&p);
    for (int i = 0; i < 3; ++i) simulation->step(simulation->max_dt());
    const auto frame = simulation->snapshot(0, {{"speed"}, false, false, false});
    EXPECT_EQ(frame->steps, 3U);
    for (const Phase phase :
         {Phase::sort, Phase::level_set, Phase::p2g, Phase::extrapolate, Phase::forces, Phase::pressure_setup,
          Phase::pressure_solve, Phase::g2p, Phase::advect, Phase::ledger, Phase::snapshot})
      EXPECT_GT(spent(p, phase).wall, 0) << phase_names[static_cast<std::size_t>(phase)] << " in " << dim << "D";
    for (const Phase phase : {Phase::draw, Phase::encode, Phase::outside}) EXPECT_EQ(spent(p, phase).wall, 0);
    EXPECT_EQ(p.solves, 3U);
    EXPECT_GE(p.iterations, p.solves);
    // About the cells of the block, 5 x 7 (x 12), in each of the three.
    EXPECT_NEAR(static_cast<double>(p.cells), 3.0 * 4.8 * 7.2 * (dim == 2 ? 1 : 12), 3.0 * 12 * (dim == 2 ? 1 : 12));
    simulation->profile(nullptr);
    simulation->step(simulation->max_dt());
    EXPECT_EQ(p.solves, 3U);
  }
}

TEST(Profile, ChangesNoResult) {
  Budget budget(2);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  const auto watched = make_simulation(column(2), pool), alone = make_simulation(column(2), pool);
  Profile p;
  watched->profile(&p);
  for (int i = 0; i < 5; ++i)
    for (const auto* s : {&watched, &alone}) (*s)->step((*s)->max_dt());
  const auto a = watched->snapshot(0, {{"speed"}, true, true, true}),
             b = alone->snapshot(0, {{"speed"}, true, true, true});
  EXPECT_EQ(a->x, b->x);
  EXPECT_EQ(a->time, b->time);
}

} // namespace
} // namespace flipbook::test
