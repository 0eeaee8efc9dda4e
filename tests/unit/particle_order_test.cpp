// SPDX-License-Identifier: MIT
#include "sim/frame/particle_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace flipbook {
namespace {

/// `n` particles, a few in each cell and some outside, listed in a random order.
Snapshot shuffled(int dim, std::size_t n, unsigned order) {
  Snapshot s;
  s.dim = dim;
  s.lo = {-1, 2, 0};
  s.cells = {4, 3, 5};
  s.dx = 0.5;
  std::vector<std::uint32_t> ids(n);
  for (std::uint32_t i = 0; i < n; ++i) ids[i] = 7 * i;
  std::shuffle(ids.begin(), ids.end(), std::mt19937(order));
  s.channels.push_back({"twice the id", "", 0, 0, false, {}});
  for (const std::uint32_t id : ids) {
    std::mt19937 random(id); // so that a particle's numbers follow from its id
    std::uniform_real_distribution<float> u(-2, 6);
    s.id.push_back(id);
    for (int a = 0; a < dim; ++a) s.x.push_back(u(random)), s.v.push_back(u(random));
    s.channels[0].values.push_back(2.0F * static_cast<float>(id));
  }
  return s;
}

TEST(ParticleOrder, FollowsFromTheParticlesAlone) {
  for (const int dim : {2, 3}) {
    Snapshot a = shuffled(dim, 500, 1), b = shuffled(dim, 500, 2);
    ASSERT_NE(a.id, b.id);
    sort_particles(a);
    sort_particles(b);
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.v, b.v);
    EXPECT_EQ(a.channels[0].values, b.channels[0].values);
    for (std::size_t p = 0; p < a.id.size(); ++p)
      EXPECT_EQ(a.channels[0].values[p], 2.0F * static_cast<float>(a.id[p])) << "columns stay together";
  }
}

TEST(ParticleOrder, IsThatOfTheCellsThenOfTheIds) {
  Snapshot s;
  s.cells = {2, 2, 1};
  s.dx = 0.5;
  s.id = {9, 4, 8, 1, 2};
  s.x = {0.9F, 0.9F, 0.1F, 0.1F, 0.6F, 0.2F, 0.2F, 0.3F, -5, 7}; // the last belongs to the upper left cell
  s.v.assign(10, 0);
  sort_particles(s);
  EXPECT_EQ(s.id, (std::vector<std::uint32_t>{1, 4, 8, 2, 9}));
}

} // namespace
} // namespace flipbook
