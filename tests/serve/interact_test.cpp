// SPDX-License-Identifier: MIT
// What a hand does to particles, in the fluid and in solids, in both dimensions.
#include "sim/boundary/dragged_motion.h"
#include "sim/frame/errors.h"
#include "sim/scene/read_scene.h"
#include "sim/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace flipbook {
namespace {

struct Case {
  const char* scene;
  int dim;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.scene << " in " << c.dim << "D";
}

class Interact : public testing::TestWithParam<Case> {
protected:
  Interact() : pool_(budget_) {
    Mistakes mistakes;
    const auto cells = GetParam().dim == 2 ? std::vector<double>{32, 32} : std::vector<double>{16, 16, 16};
    const std::vector<Assignment> changes{{"dim", static_cast<double>(GetParam().dim), {}},
                                          {"grid.cells", cells, {}},
                                          {"precision", std::string("double"), {}}};
    scene_ = make_scene(load_scene(GetParam().scene), changes, mistakes);
    mistakes.raise();
    simulation_ = make_simulation(scene_, pool_);
  }

  void act(const Interaction& what) {
    const Refusal r = simulation_->interact(what);
    EXPECT_EQ(r.message, "");
  }
  std::shared_ptr<const Snapshot> look() { return simulation_->peek(0, {}); }
  void steps(int n) {
    for (int i = 0; i < n; ++i) simulation_->step(simulation_->max_dt());
  }
  static double distance(const Snapshot& s, std::size_t p, const Triple& at) {
    double square = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(s.dim); ++d) {
      const double x = static_cast<double>(s.x[static_cast<std::size_t>(s.dim) * p + d]) - at[d];
      square += x * x;
    }
    return std::sqrt(square);
  }
  /// Where some particle is.
  static Triple place(const Snapshot& s) {
    Triple at{0, 0, 0};
    const std::size_t p = s.particles() / 2, dim = static_cast<std::size_t>(s.dim);
    for (std::size_t d = 0; d < dim; ++d) at[d] = static_cast<double>(s.x[dim * p + d]);
    return at;
  }

  Budget budget_{2};
  Budget::Permit permit_{budget_};
  Pool pool_;
  Scene scene_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_P(Interact, APushTakesAlongWhatIsNear) {
  steps(3);
  const auto before = look();
  const Triple at = place(*before), V{0.5, -0.25, 0};
  const double radius = 4 * before->dx;
  act(Push{at, radius, V});
  const auto after = look();
  ASSERT_EQ(after->x, before->x);
  const auto dim = static_cast<std::size_t>(after->dim);
  int near = 0;
  for (std::size_t p = 0; p < after->particles(); ++p) {
    const double s = std::pow(distance(*after, p, at) / radius, 2), w = s < 1 ? (1 - s) * (1 - s) : 0;
    near += w > 0 ? 1 : 0;
    for (std::size_t d = 0; d < dim; ++d) {
      const double v = static_cast<double>(before->v[dim * p + d]);
      EXPECT_NEAR(static_cast<double>(after->v[dim * p + d]), v + w * (V[d] - v), 1e-5); // snapshots are in single
    }
  }
  EXPECT_GT(near, 10);
  steps(3);
}

TEST_P(Interact, WhatIsRemovedIsGoneAndTheRestStays) {
  steps(2);
  const auto before = look();
  const Triple at = place(*before);
  const double radius = 3 * before->dx;
  act(RemoveParticles{at, radius});
  const auto after = look();
  std::size_t within = 0;
  for (std::size_t p = 0; p < before->particles(); ++p) within += distance(*before, p, at) < radius ? 1U : 0U;
  EXPECT_GT(within, 5U);
  EXPECT_NEAR(static_cast<double>(before->particles() - after->particles()), static_cast<double>(within), 2); // single
  for (std::size_t p = 0; p < after->particles(); ++p) EXPECT_GT(distance(*after, p, at), radius * (1 - 1e-5));
  steps(3);
}

TEST_P(Interact, WhatIsAddedFillsWhatIsEmptyOnce) {
  steps(2);
  const auto before = look();
  const Triple at = place(*before);
  const double radius = 3 * before->dx;
  act(RemoveParticles{at, radius});
  const std::size_t least = look()->particles();
  act(AddParticles{at, radius, {0, 0, 0}});
  const auto full = look();
  EXPECT_GT(full->particles(), least + 10);
  act(AddParticles{at, radius, {0, 0, 0}}); // every sub-cell is taken now
  EXPECT_EQ(look()->particles(), full->particles());
  std::set<std::uint32_t> ids(full->id.begin(), full->id.end());
  EXPECT_EQ(ids.size(), full->particles()); // no id twice,
  for (const std::uint32_t id : before->id) ids.insert(id);
  act(RemoveParticles{at, radius});
  act(AddParticles{at, radius, {0, 0, 0}});
  const auto again = look();
  const std::uint32_t last = *std::max_element(full->id.begin(), full->id.end());
  for (const std::uint32_t id : again->id) EXPECT_TRUE(id <= last || ids.insert(id).second); // or again
  steps(3);
  const auto snapshot = simulation_->snapshot(1, {{"initial_x"}});
  EXPECT_EQ(snapshot->channels.front().values.size(), simulation_->particles());
}

TEST_P(Interact, OneParticleIsLeft) {
  act(RemoveParticles{{0.5, 0.5, 0.5}, 1.5});
  EXPECT_EQ(simulation_->particles(), 1U);
  steps(2);
  act(AddParticles{{0.5, 0.5, 0.5}, 0.2, {0, 0, 0}});
  EXPECT_GT(simulation_->particles(), 20U);
  steps(5);
}

TEST_P(Interact, NonsenseIsRefused) {
  const double nan = std::nan(""), inf = HUGE_VAL;
  for (const Interaction& bad :
       {Interaction(Push{{nan, 0, 0}, 0.1, {0, 0, 0}}), Interaction(Push{{0, 0, 0}, -1, {}}),
        Interaction(AddParticles{{0, inf, 0}, 0.1, {}}), Interaction(AddParticles{{0, 0, 0}, nan, {}}),
        Interaction(RemoveParticles{{1e9, 0, 0}, 0.1}), Interaction(MoveSolid{99, {0, 0, 0}, 0.1})})
    EXPECT_NE(simulation_->interact(bad).message, "");
}

TEST_P(Interact, APeekLeavesNoTrace) {
  const auto other = make_simulation(scene_, pool_);
  const FrameRequest request{{"speed"}};
  for (std::uint64_t k = 0; k < 4; ++k) {
    const double dt = simulation_->max_dt();
    simulation_->step(dt);
    other->step(dt);
    (void)simulation_->peek(k, {{"speed", "pressure"}});
    const auto a = simulation_->snapshot(k, request), b = other->snapshot(k, request);
    EXPECT_EQ(a->x, b->x);
    EXPECT_EQ(a->history->t, b->history->t);
    EXPECT_EQ(a->channels.front().hi, b->channels.front().hi);
    ASSERT_EQ(a->history->columns.size(), b->history->columns.size());
    for (std::size_t c = 0; c < a->history->columns.size(); ++c)
      EXPECT_EQ(a->history->columns[c].y, b->history->columns[c].y) << a->history->columns[c].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, Interact,
                         testing::Values(Case{"dam_break", 2}, Case{"dam_break", 3}, Case{"two_blocks", 2},
                                         Case{"snowball", 2}, Case{"jelly_cubes", 3}));

TEST(DraggedMotion, GoesOnFromWhereItIsAndStops) {
  DraggedMotion m(nullptr);
  EXPECT_EQ(m.at(3).shift, (Point{0, 0, 0}));
  m.drag(1, {2, 0, 0}, 2);
  EXPECT_EQ(m.at(0).shift[0], 0);
  EXPECT_EQ(m.at(1).shift[0], 0);
  EXPECT_EQ(m.at(2).shift[0], 1);
  EXPECT_EQ(m.at(3).shift[0], 2);
  EXPECT_EQ(m.at(9).shift[0], 2);
  m.drag(2, {0, 4, 0}, 1); // the hand turns before it has arrived
  EXPECT_EQ(m.at(1.5).shift, (Point{0.5, 0, 0}));
  EXPECT_EQ(m.at(2.5).shift, (Point{1, 2, 0}));
  EXPECT_EQ(m.at(9).shift, (Point{1, 4, 0}));
}

TEST(DraggedMotion, MovesAnObstacleAndTheFluidWithIt) {
  Budget budget(2);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  Mistakes mistakes;
  const std::vector<Assignment> changes{{"grid.cells", std::vector<double>{64, 32}, {}}};
  const Scene scene = make_scene(load_scene("dam_break_pillar"), changes, mistakes);
  const auto simulation = make_simulation(scene, pool);
  const auto before = simulation->snapshot(0, {});
  ASSERT_FALSE(before->solids.empty());
  EXPECT_EQ(simulation->interact(MoveSolid{0, {0.1, 0.05, 0}, 0.1}).message, "");
  while (simulation->time() < 0.2) simulation->step(std::min(simulation->max_dt(), 0.02));
  const auto after = simulation->snapshot(1, {});
  EXPECT_NEAR(after->solids[0].pose.shift[0] - before->solids[0].pose.shift[0], 0.1, 1e-12);
  EXPECT_NEAR(after->solids[0].pose.shift[1] - before->solids[0].pose.shift[1], 0.05, 1e-12);
}

} // namespace
} // namespace flipbook
