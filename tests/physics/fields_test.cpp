// SPDX-License-Identifier: MIT
// Quantities of the grid as lattices for images, against flows that are known.
#include "sim/fluid/fields.h"
#include "tests/physics/solids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace flipbook::test {
namespace {

const LatticeData& named(const std::vector<LatticeData>& all, const std::string& name) {
  for (const LatticeData& l : all)
    if (l.name == name) return l;
  throw std::out_of_range(name);
}
double held(const LatticeData& l, int i, int j) {
  return static_cast<double>(
      l.values[static_cast<std::size_t>(i) + static_cast<std::size_t>(l.n[0]) * static_cast<std::size_t>(j)]);
}

FrameRequest everything() {
  FrameRequest r;
  r.fields = {"pressure", "divergence", "vorticity", "speed", "velocity_x", "velocity_y"};
  r.surface = r.cells = true;
  return r;
}

Settings tank_settings() {
  return box({16, 12, 16}, 0.125);
}
Flow<2> tank(std::vector<Obstacle> obstacles = {}) {
  const Settings s = tank_settings();
  return {s, seed_around<2>(s, obstacles, [](const auto& x) { return x[1] < 0.75; }), 1, obstacles};
}

TEST(Fields, TheSurfaceOfAPoolIsAtItsDepth) {
  auto flow = tank();
  const LatticeData l = named(image_lattices(flow.state(), everything(), flow.pool), "surface");
  ASSERT_EQ(l.n, (std::array{16, 12, 1}));
  for (int i = 0; i < 16; ++i) {
    const double below = held(l, i, 5), above = held(l, i, 6); // centres at 11/16 and 13/16
    EXPECT_NEAR(0.6875 + 0.125 * below / (below - above), 0.75, 1e-6);
  }
}

TEST(Fields, CellsAreWhatTheSolverTakesThemFor) {
  auto flow = tank({{make_box(at(0.49, 0.24), at(1.01, 0.51))}});
  const LatticeData l = named(image_lattices(flow.state(), everything(), flow.pool), "cells");
  for (int j = 0; j < 12; ++j)
    for (int i = 0; i < 16; ++i) {
      const bool in_box = i >= 4 && i < 8 && j >= 2 && j < 4;
      EXPECT_EQ(held(l, i, j), in_box ? 2 : j < 6 ? 1 : 0) << i << " " << j;
    }
}

/// The lattices belong to the particles of the picture, not to where they were before they moved.
TEST(Fields, TheSurfaceFollowsTheParticles) {
  Settings s = tank_settings();
  s.fluid.gravity = {0, 0, 0};
  const auto inside = [](const auto& x) { return std::hypot(x[0] - 0.6, x[1] - 0.6) < 0.3; };
  Flow<2> flow(s, seed<2>(s, inside, [](const auto&) { return Vec<2, double>{1, 0.5}; }));
  flow.solver.step(0.05);
  const Flow<2> fresh(s, flow.particles());
  const auto now = image_lattices(flow.state(), everything(), flow.pool);
  const LatticeData &surface = named(now, "surface"), &cells = named(now, "cells");
  bool moved = false;
  for (int j = 0; j < 12; ++j)
    for (int i = 0; i < 16; ++i) {
      const auto where = static_cast<std::size_t>(fresh.state().grid.at({i + 2, j + 2}));
      EXPECT_NEAR(held(surface, i, j), fresh.state().phi[where], 1e-6);
      EXPECT_EQ(held(cells, i, j), fresh.state().cells.fluid[where]);
      moved = moved || std::abs(fresh.state().phi[where] - flow.state().phi[where]) > 0.01;
    }
  EXPECT_TRUE(moved);
}

/// Hydrostatic: p = rho g depth at the centres of cells, in a solid cell what the liquid beside it has; no divergence.
TEST(Fields, PressureAndDivergenceOfAPoolAtRest) {
  auto flow = tank({{make_box(at(0.49, 0.24), at(1.01, 0.51))}});
  flow.solver.step(0.01);
  const auto all = image_lattices(flow.state(), everything(), flow.pool);
  const LatticeData &p = named(all, "pressure"), &div = named(all, "divergence");
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 12; ++j) {
      const bool in_box = i >= 4 && i < 8 && j >= 2 && j < 4;
      if (!in_box) {
        EXPECT_NEAR(held(p, i, j), j < 6 ? 9810 * (0.75 - 0.125 * (j + 0.5)) : 0, 2) << i << " " << j;
      }
      EXPECT_NEAR(held(div, i, j), 0, 1e-6) << i << " " << j;
    }
  EXPECT_NEAR(held(p, 5, 2), 9810 * (0.75 - 0.125 * 1.5), 2) << "the mean of its one liquid neighbour, below";
  EXPECT_NEAR(held(p, 4, 2), 9810 * (0.75 - 0.125 * 2), 2) << "of the ones on the left and below";
}

/// u = (-3 (y - 1/2), 3 (x - 1/2)): vorticity 6, speed 3 r.
TEST(Fields, OfARigidRotation) {
  Settings s = box({12, 12, 12}, 1.0 / 12);
  s.fluid.surface = Surface::full;
  s.fluid.gravity = {0, 0, 0};
  s.transfer.scheme = pic;
  Flow<2> flow(s, seed<2>(s, everywhere<2>, [](const auto& x) {
                 return Vec<2, double>{-3 * (x[1] - 0.5), 3 * (x[0] - 0.5)};
               }));
  const auto all = image_lattices(flow.state(), everything(), flow.pool);
  const LatticeData &w = named(all, "vorticity"), &speed = named(all, "speed"), &u = named(all, "velocity_x"),
                    &surface = named(all, "surface"), &div = named(all, "divergence");
  ASSERT_EQ(w.n, (std::array{13, 13, 1}));
  ASSERT_EQ(speed.n, (std::array{25, 25, 1}));
  for (int j = 3; j < 10; ++j)
    for (int i = 3; i < 10; ++i) {
      EXPECT_NEAR(held(w, i, j), 6, 1e-4);
      EXPECT_NEAR(held(u, i, j), -3 * ((j + 0.5) / 12 - 0.5), 1e-5);
      EXPECT_NEAR(held(div, i, j), 0, 1e-5);
    }
  for (int j = 6; j < 19; ++j)
    for (int i = 6; i < 19; ++i) EXPECT_NEAR(held(speed, i, j), 3 * std::hypot(i / 24.0 - 0.5, j / 24.0 - 0.5), 1e-5);
  EXPECT_THAT(surface.values, testing::Each(testing::Lt(0))) << "a liquid that fills the domain has no surface";
}

TEST(Fields, ArePublishedOnlyWhereAskedFor) {
  auto flow = tank();
  EXPECT_TRUE(flow.solver.snapshot(0, {})->lattices.empty());
  FrameRequest r;
  r.fields = {"noise", "speed"}; // no lattice has the noise
  ASSERT_EQ(flow.solver.snapshot(1, r)->lattices.size(), 1U);
  EXPECT_EQ(flow.solver.snapshot(1, r)->lattices[0].name, "speed");
  r.trails = 1;
  EXPECT_EQ(flow.solver.snapshot(2, r)->trails.size(), 1U);
}

} // namespace
} // namespace flipbook::test
