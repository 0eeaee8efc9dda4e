// SPDX-License-Identifier: MIT
#include "sim/fluid/extrapolate.h"
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

/// u known on one column of y faces, with the value of their height; NaN elsewhere.
struct Column {
  Settings settings;
  Grid<2> grid;
  Walls<2, double> walls;
  Components<2, double> u;
  Known<2> known;
  Budget budget{1};
  Pool pool{budget};
  Budget::Permit permit{budget};

  Column(int x, Wall wall) : settings(with(wall)), grid(grid_of<2>(settings)), walls(grid, settings.walls) {
    u.resize(grid);
    for (std::size_t a = 0; a < 2; ++a) known[a].assign(u[a].size(), 0);
    std::fill(u[1].begin(), u[1].end(), std::nan(""));
    for (int y = 2; y <= 12; ++y) {
      const auto at = static_cast<std::size_t>(grid.at({x, y}));
      known[1][at] = 1;
      u[1][at] = y;
    }
  }
  static Settings with(Wall wall) {
    Settings s = box({10, 10, 10}, 0.1);
    s.walls.axis[0] = wall;
    return s;
  }
  [[nodiscard]] double at(int x, int y) const { return u[1][static_cast<std::size_t>(grid.at({x, y}))]; }
};

TEST(Extrapolate, GoesLayerByLayerAndNoFarther) {
  Column c(4, Wall::free_slip);
  extrapolate(c.grid, c.walls, c.known, 3, c.u, c.pool);
  for (int y = 2; y <= 12; ++y) {
    for (const int x : {2, 3, 4, 5, 6, 7}) EXPECT_EQ(c.at(x, y), y) << x; // one known neighbour each: its value
    EXPECT_TRUE(std::isnan(c.at(8, y)));
    EXPECT_TRUE(std::isnan(c.at(11, y)));
  }
}

TEST(Extrapolate, CrossesPeriodicSidesFromTheFirstLayerOn) {
  for (const int x : {2, 3}) {
    Column c(x, Wall::periodic);
    extrapolate(c.grid, c.walls, c.known, 2, c.u, c.pool);
    for (int y = 2; y <= 12; ++y) {
      EXPECT_EQ(c.at(11, y), y) << x;
      EXPECT_TRUE(std::isnan(c.at(8, y)));
    }
    EXPECT_EQ(std::isnan(c.at(10, 5)), x == 3);
  }
}

TEST(Extrapolate, TakesTheMeanOfWhatIsKnown) {
  Column c(4, Wall::free_slip);
  const auto middle = static_cast<std::size_t>(c.grid.at({6, 7}));
  c.known[1][middle] = 1;
  c.u[1][middle] = 100;
  extrapolate(c.grid, c.walls, c.known, 1, c.u, c.pool);
  EXPECT_EQ(c.at(5, 7), 53.5);
  EXPECT_EQ(c.at(5, 6), 6);
  EXPECT_EQ(c.at(6, 8), 100);
  EXPECT_EQ(c.at(6, 7), 100);
}

} // namespace
} // namespace flipbook::test
