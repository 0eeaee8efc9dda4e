// SPDX-License-Identifier: MIT
// How far a body of particles has come: exact for a lattice, blind for single drops.
#include "sim/core/reach.h"

#include <gtest/gtest.h>

namespace flipbook {
namespace {

using Points = std::vector<std::array<double, 3>>;

/// A full lattice in [0, hi], `per_axis` particles in a cell along an axis.
Points lattice(int dim, const std::array<double, 3>& hi, double dx, int per_axis) {
  const double h = dx / per_axis;
  Points all;
  const auto count = [&](std::size_t a) { return static_cast<int>(std::lround(hi[a] / h)); };
  for (int k = 0; k < (dim == 3 ? count(2) : 1); ++k)
    for (int j = 0; j < count(1); ++j)
      for (int i = 0; i < count(0); ++i) all.push_back({(i + 0.5) * h, (j + 0.5) * h, dim == 3 ? (k + 0.5) * h : 0});
  return all;
}

DamReach reached(int dim, const Points& x, int per_axis = 2, std::array<double, 3> up = {0, 1, 0}) {
  ReachFrame f;
  f.dim = dim;
  f.size = {2, 1, 1};
  f.dx = 0.125;
  f.per_axis = per_axis;
  return dam_reach(f, up, x.size(), [&](std::size_t p, int axis) { return x[p][static_cast<std::size_t>(axis)]; });
}

TEST(Reach, OfALatticeIsWhereItEnds) {
  for (const int dim : {2, 3})
    for (const int per_axis : {1, 2, 3}) {
      const DamReach r = reached(dim, lattice(dim, {0.5, 0.75, 1}, 0.125, per_axis), per_axis);
      EXPECT_NEAR(r.front, 0.5, 1e-12) << dim << " " << per_axis;
      EXPECT_NEAR(r.height, 0.75, 1e-12) << dim << " " << per_axis;
    }
}

TEST(Reach, DoesNotFollowSingleDrops) {
  for (const int dim : {2, 3}) {
    Points x = lattice(dim, {0.5, 0.75, 1}, 0.125, 2);
    for (const double ahead : {1.9, 1.5, 1.2}) x.push_back({ahead, 0.01, 0.5}); // on the floor
    for (const double high : {0.95, 0.9, 0.85}) x.push_back({0.01, high, 0.5}); // at the wall
    x.push_back({1.99, 0.5, 0.5});                                              // in flight
    const DamReach r = reached(dim, x);
    EXPECT_NEAR(r.front, 0.5, 0.125) << dim;
    EXPECT_NEAR(r.height, 0.75, 0.125) << dim;
  }
}

/// A tongue half a cell thin is still the front.
TEST(Reach, FollowsThinLayers) {
  Points x = lattice(2, {0.5, 0.75, 0}, 0.125, 2);
  for (double at = 0.53125; at < 1.25; at += 0.0625) x.push_back({at, 0.03, 0});
  EXPECT_NEAR(reached(2, x).front, 1.25, 0.125);
}

TEST(Reach, IsNothingWithoutLiquidOnTheWall) {
  EXPECT_EQ(reached(2, {{0.5, 0.5, 0}}).front, 0);
  EXPECT_EQ(reached(2, {}).height, 0);
}

/// The same column turned: gravity along -x, then upwards.
TEST(Reach, TurnsWithGravity) {
  Points x = lattice(2, {0.5, 0.75, 0}, 0.125, 2), turned = x, hanging = x;
  for (auto& p : turned) std::swap(p[0], p[1]);
  EXPECT_NEAR(reached(2, turned, 2, {1, 0, 0}).front, 0.5, 1e-12);
  EXPECT_NEAR(reached(2, turned, 2, {1, 0, 0}).height, 0.75, 1e-12);
  for (auto& p : hanging) p[1] = 1 - p[1];
  EXPECT_NEAR(reached(2, hanging, 2, {0, -1, 0}).front, 0.5, 1e-12);
  EXPECT_NEAR(reached(2, hanging, 2, {0, -1, 0}).height, 0.75, 1e-12);
}

} // namespace
} // namespace flipbook
