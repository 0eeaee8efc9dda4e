// SPDX-License-Identifier: MIT
// Trails: the same particles in every pane, no more of them and no more points than fixed, of the time asked for.
#include "sim/frame/trails.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace flipbook {
namespace {

/// `count` particles at (id, time), in an order of their own.
Snapshot at(double time, std::uint32_t count) {
  Snapshot s;
  s.time = time;
  s.id.resize(count);
  std::iota(s.id.begin(), s.id.end(), 0U);
  std::rotate(s.id.begin(), s.id.begin() + static_cast<std::ptrdiff_t>(count) / 3, s.id.end());
  for (const std::uint32_t id : s.id) s.x.insert(s.x.end(), {static_cast<float>(id), static_cast<float>(time)});
  s.v.resize(s.x.size());
  return s;
}

TEST(Trails, HoldTheTimeThatIsAskedFor) {
  Trails trails;
  Snapshot s;
  for (int k = 0; k <= 20; ++k) trails.follow(s = at(0.1 * k, 50), 0.5);
  ASSERT_EQ(s.trails.size(), 6U);
  EXPECT_NEAR(s.trails.front()->time, 1.5, 1e-12);
  EXPECT_EQ(s.trails.back()->time, s.time);
  EXPECT_EQ(s.trails.back()->id.size(), 50U) << "few particles: all of them";
  for (const auto& row : s.trails)
    for (std::size_t i = 0; i < row->id.size(); ++i) {
      EXPECT_EQ(row->x[2 * i], static_cast<float>(row->id[i]));
      EXPECT_EQ(row->x[2 * i + 1], static_cast<float>(row->time));
    }
}

TEST(Trails, AreFewAndShort) {
  Trails trails;
  Snapshot s;
  for (int k = 0; k <= 5000; ++k) trails.follow(s = at(1e-3 * k, 20000), 4);
  EXPECT_LE(s.trails.size(), Trails::most_rows + 2);
  EXPECT_GT(s.trails.size(), Trails::most_rows / 2);
  EXPECT_NEAR(s.trails.front()->time, 1, 0.06);
  EXPECT_GT(s.trails.back()->id.size(), Trails::most_ways / 2);
  EXPECT_LE(s.trails.back()->id.size(), 2 * Trails::most_ways);
  for (std::size_t i = 1; i < s.trails.size(); ++i) EXPECT_GT(s.trails[i]->time, s.trails[i - 1]->time);
}

TEST(Trails, FollowTheSameParticlesWhereverTheyAre) {
  Trails one, other;
  Snapshot a = at(0, 9000), b = at(0, 9000);
  std::reverse(b.id.begin(), b.id.end());
  one.follow(a, 1);
  other.follow(b, 1);
  EXPECT_EQ(a.trails[0]->id, b.trails[0]->id);
  EXPECT_TRUE(std::is_sorted(a.trails[0]->id.begin(), a.trails[0]->id.end()));
}

TEST(Trails, StayFewWhereParticlesComeIn) {
  Trails trails;
  Snapshot s;
  trails.follow(s = at(0, 100), 1);
  trails.follow(s = at(0.1, 100000), 1);
  EXPECT_LE(s.trails.back()->id.size(), 2 * Trails::most_ways);
  EXPECT_GT(s.trails.back()->id.size(), Trails::most_ways / 4);
}

TEST(Trails, CostNothingWhereNobodyAsks) {
  Trails trails;
  Snapshot s = at(0, 100), space = at(0, 90);
  trails.follow(s, 0);
  EXPECT_TRUE(s.trails.empty());
  space.dim = 3;
  trails.follow(space, 1);
  EXPECT_TRUE(space.trails.empty()) << "drawn in 2D only";
}

} // namespace
} // namespace flipbook
