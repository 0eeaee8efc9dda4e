// SPDX-License-Identifier: MIT
#include "sim/fluid/level_set.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

/// The distance to the nearest of all particles and of their images across periodic sides.
template <int Dim>
double brute_force(const Settings& s, const Particles<Dim, double>& particles, const Vec<Dim, double>& x) {
  double nearest = 1e30;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    Vec<Dim, double> r = x - particles.position(p);
    for (int d = 0; d < Dim; ++d)
      if (s.walls.axis[static_cast<std::size_t>(d)] == Wall::periodic)
        r[d] -= s.grid.size[static_cast<std::size_t>(d)] * std::round(r[d] / s.grid.size[static_cast<std::size_t>(d)]);
    nearest = std::min(nearest, r.norm());
  }
  return nearest;
}

template <int Dim> void expect_distances(Wall wall) {
  Settings s = box({12, 10, 8}, 0.1, Dim);
  s.walls.axis = {wall, Wall::free_slip, wall};
  s.seeding.pattern = Pattern::jittered;
  // A few particles here and there, at the sides as well.
  const auto particles = seed<Dim>(
      s,
      [&](const auto& x) {
        return uniform(5, static_cast<std::uint64_t>(1e6 * x[0]), static_cast<std::uint64_t>(1e6 * x[1])) < 0.03;
      },
      at_rest<Dim>);
  Flow<Dim> flow(s, particles);
  const auto& state = flow.state();
  const double r = particle_radius<Dim>(0.1, 2);
  int near = 0;
  each_in(state.grid, cells_of(state.grid), [&](const Index<Dim>& i, std::size_t at) {
    const Vec<Dim, double> centre = 0.1 * (i.template cast<double>().array() - 1.5);
    const double distance = brute_force<Dim>(s, particles, centre);
    if (distance < 0.2) {
      EXPECT_NEAR(state.phi[at], distance - r, 1e-12);
      ++near;
    } else {
      EXPECT_GE(state.phi[at], 0.2 - r - 1e-12);
    }
  });
  EXPECT_GT(near, 20);
}

TEST(LevelSet, IsTheDistanceToTheNearestParticleLessTheRadius) {
  for (const Wall wall : {Wall::free_slip, Wall::periodic}) {
    expect_distances<2>(wall);
    expect_distances<3>(wall);
  }
}

TEST(LevelSet, RadiusScalesWithTheSpacing) {
  EXPECT_NEAR(particle_radius<2>(1, 2), 0.572, 0.002);
  EXPECT_NEAR(particle_radius<3>(1, 2), 0.631, 0.002);
  EXPECT_NEAR(particle_radius<2>(1, 4), particle_radius<2>(1, 2) / 2, 1e-15);
}

} // namespace
} // namespace flipbook::test
