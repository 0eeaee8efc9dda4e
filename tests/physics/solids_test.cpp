// SPDX-License-Identifier: MIT
// Obstacles on the grid: open fractions, still water, a piston, particles that are pushed out.
#include "tests/physics/solids.h"

#include "sim/fluid/cut_face.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

// === Open fractions

TEST(CutFace, OfAPlaneIsExact) {
  // phi = 0.3 b - 0.1 on the edge from b = -1/2 to 1/2: open beyond b = 1/3.
  const CutFace<2> edge = cut_face<2>({-0.25, 0.05});
  EXPECT_NEAR(edge.open, 1.0 / 6, 1e-15);
  EXPECT_NEAR(edge.solid_centre[0], -1.0 / 12, 1e-15);

  // phi = x + 2 y + c on the square: the solid part is a trapezium, a triangle, or the square without a triangle.
  const auto plane = [](double c) { return cut_face<3>({-1.5 + c, -0.5 + c, 0.5 + c, 1.5 + c}); };
  EXPECT_NEAR(plane(0).open, 0.5, 1e-15);
  EXPECT_NEAR(plane(-1).open, 1.0 / 16, 1e-15); // the triangle x + 2 y > 1 with sides 1/2 and 1/4
  EXPECT_NEAR(plane(1).open, 1 - 1.0 / 16, 1e-15);
  EXPECT_NEAR(plane(1).solid_centre[0], -0.5 + 1.0 / 6, 1e-14);
  EXPECT_NEAR(plane(1).solid_centre[1], -0.5 + 1.0 / 12, 1e-14);
  EXPECT_NEAR(plane(-1).solid_centre[0], -(0.5 - 1.0 / 6) / 15, 1e-14); // moments of both parts add up to none
  EXPECT_EQ(plane(2).open, 1);
  EXPECT_EQ(plane(-2).open, 0);
}

TEST(CutFace, OfASaddleJoinsWhatHasTheSignOfTheMean) {
  EXPECT_NEAR((cut_face<3>({1, -0.5, -0.5, 1}).open), 1 - 2 * (1.0 / 3) * (1.0 / 3) / 2, 1e-15);
  EXPECT_NEAR((cut_face<3>({-1, 0.5, 0.5, -1}).open), 2 * (1.0 / 3) * (1.0 / 3) / 2, 1e-15);
  EXPECT_EQ((cut_face<3>({0, 0, 0, 0}).open), 0) << "a face in the surface is closed";
}

/// Mean error of the open fractions that are neither 0 nor 1, for a disc: on a vertical face the solid part is a chord.
double disc_error(int cells) {
  const double r = 0.31, x0 = 0.5, y0 = 0.52, dx = 1.0 / cells;
  Flow<2> flow(box({cells, cells, cells}, dx), {}, 1, {{make_ball(at(x0, y0), r)}});
  double sum = 0;
  int count = 0;
  each_in(flow.state().grid, faces_of(flow.state().grid, 0), [&](const Index<2>& i, std::size_t where) {
    const double x = dx * (i[0] - 2) - x0, y = dx * (i[1] - 2) - y0;
    if (std::abs(x) >= r || i[0] == 2 || i[0] == 2 + cells) return;
    const double half = std::sqrt(r * r - x * x);
    const double solid = std::clamp(std::min(half, y + dx) - std::max(-half, y), 0.0, dx) / dx;
    const double error = std::abs(flow.state().walls.open[0][where] - (1 - solid));
    if (solid > 0 && solid < 1) sum += error, ++count;
  });
  return sum / count;
}

/// The volume of a ball in 3D, as the sum of its cuts by planes of faces.
double ball_volume_error(int cells) {
  const double r = 0.31, dx = 1.0 / cells;
  Flow<3> flow(box({cells, cells, cells}, dx, 3), {}, 1, {{make_ball(at(0.5, 0.52, 0.47), r)}});
  double solid = 0;
  Box<3> inner = faces_of(flow.state().grid, 1);
  ++inner.lo[1], --inner.hi[1];
  each_in(flow.state().grid, inner,
          [&](const Index<3>&, std::size_t where) { solid += 1 - flow.state().walls.open[1][where]; });
  const double volume = 4 * std::numbers::pi / 3 * r * r * r;
  return std::abs(solid * dx * dx * dx - volume) / volume;
}

TEST(OpenFaces, OfABallConverge) {
  EXPECT_LT(disc_error(32), 0.01);
  EXPECT_LT(disc_error(128), 0.0025);
  EXPECT_LT(ball_volume_error(32), 0.01);
  EXPECT_LT(ball_volume_error(64), 0.0025);
}

TEST(OpenFaces, OfAPlaneAreExact) {
  const int n = 20;
  const Settings s = box({n, n, n}, 1.0 / n);
  Flow<2> flow(s, {}, 1, {{make_half_space(at(0.5, 0.5), at(1, 2))}});
  const auto& state = flow.state();
  for (int a = 0; a < 2; ++a) {
    Box<2> box = faces_of(state.grid, a);
    ++box.lo[a], --box.hi[a];
    each_in(state.grid, box, [&](const Index<2>& i, std::size_t where) {
      // phi along the face, from one end to the other, in cells
      const double x = i[0] - 2 - 10, y = i[1] - 2 - 10, lo = x + 2 * y, hi = lo + (a == 0 ? 2 : 1);
      double open = std::clamp(hi / (hi - lo), 0.0, 1.0);
      EXPECT_NEAR(state.walls.open[static_cast<std::size_t>(a)][where], open, 1e-12) << i.transpose();
    });
  }
}

/// Walls in the planes of the grid's faces close those faces, and no cell inside keeps an open one.
TEST(OpenFaces, OfABoxOnTheGridAreOpenOrClosed) {
  const Settings s = box({10, 10, 10}, 0.1, 3);
  Flow<3> flow(s, {}, 1, {{make_box(at(0.2, 0.3, 0.4), at(0.5, 0.6, 0.8))}});
  const auto& state = flow.state();
  int closed = 0;
  each_in(state.grid, faces_of(state.grid, 1), [&](const Index<3>& i, std::size_t where) {
    if (i[1] == 2 || i[1] == 12) return;
    const bool inside = i[0] >= 4 && i[0] < 7 && i[1] >= 5 && i[1] <= 8 && i[2] >= 6 && i[2] < 10;
    EXPECT_EQ(state.walls.open[1][where], inside ? 0 : 1) << i.transpose();
    closed += inside;
  });
  EXPECT_EQ(closed, 3 * 4 * 4);
}

/// What a turning plane pushes into each cell that it cuts is exact: U.n at the middle of the cut, times its length.
TEST(OpenFaces, MoveAsTheirSolidPartDoes) {
  const int n = 12;
  const double omega = 2;
  const Vec<2, double> normal = Vec<2, double>(1, 2) / std::sqrt(5.0);
  const auto turning = scripted(
      [](double) {
        return Point{0, 0, 0};
      },
      [=](double t) { return omega * t; }, {0.3, 0.4, 0});
  Flow<2> flow(box({n, n, n}, 1.0 / n), {}, 1, {{make_half_space(at(0.47, 0.52), at(1, 2)), turning}});
  flow.solver.step(1e-9);
  const auto& s = flow.state();
  int cut = 0;
  each_in(s.grid, Box<2>{{3, 3}, {1 + n, 1 + n}}, [&](const Index<2>& i, std::size_t at) {
    std::vector<Vec<2, double>> ends; // of the cut: where the plane crosses the sides of the cell
    const Vec<2, double> lo = s.grid.dx * (i.cast<double>().array() - 2).matrix();
    for (int a = 0; a < 2; ++a)
      for (const double side : {0.0, 1.0}) {
        Vec<2, double> x = lo;
        x[a] += side * s.grid.dx;
        x[1 - a] =
            Vec<2, double>(0.47, 0.52)[1 - a] - normal[a] / normal[1 - a] * (x[a] - Vec<2, double>(0.47, 0.52)[a]);
        if (x[1 - a] > lo[1 - a] && x[1 - a] < lo[1 - a] + s.grid.dx) ends.push_back(x);
      }
    if (ends.size() != 2) return;
    const Vec<2, double> x = (ends[0] + ends[1]) / 2, U(-omega * (x[1] - 0.4), omega * (x[0] - 0.3));
    const double pushed = U.dot(normal) * (ends[0] - ends[1]).norm() / (s.grid.dx * s.grid.dx);
    Components<2, double> still;
    still.resize(s.grid);
    EXPECT_NEAR(divergence(s.grid, s.walls, still, at), -pushed, 1e-5) << i.transpose();
    ++cut;
  });
  EXPECT_GT(cut, 10);
}

/// Across a periodic side a ball goes on.
TEST(OpenFaces, GoOnAcrossPeriodicSides) {
  Settings s = periodic_box(24, 1);
  const auto faces = [&](double x) {
    Flow<2> flow(s, {}, 1, {{make_ball(at(x, 0.5), 0.2)}});
    std::vector<double> open;
    each_in(flow.state().grid, cells_of(flow.state().grid),
            [&](const Index<2>&, std::size_t where) { open.push_back(flow.state().walls.open[0][where]); });
    std::sort(open.begin(), open.end());
    return open;
  };
  const auto middle = faces(0.5), side = faces(0);
  ASSERT_LT(middle.front(), 1);
  for (std::size_t i = 0; i < middle.size(); ++i) EXPECT_NEAR(middle[i], side[i], 1e-12);
}

// === Still water

template <int Dim> Flow<Dim> still_pool(int cells, int scheme, Splitting splitting, double level) {
  Settings s = box({cells, cells, cells}, 1.0 / cells, Dim);
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  const std::vector<Obstacle> obstacles{{make_ball(at(0.52, 0.38, 0.49), 0.13)},
                                        {make_half_space(at(0.5, 0.12), at(0.31, 1))}};
  return Flow<Dim>(s, seed_around<Dim>(s, obstacles, [=](const auto& x) { return x[1] < level; }), 1, obstacles);
}

template <int Dim> void expect_still(int cells, int scheme, Splitting splitting, double bound) {
  auto flow = still_pool<Dim>(cells, scheme, splitting, 0.75);
  flow.run_to(0.5);
  EXPECT_LT(flow.max_speed(), bound) << scheme_names[scheme];
  const auto& s = flow.state();
  double worst = 0;
  each_in(s.grid, cells_of(s.grid), [&](const Index<Dim>& i, std::size_t at) {
    if (!s.cells.fluid[at]) return;
    const double depth = 0.75 - s.grid.dx * (i[1] - 1.5);
    worst = std::max(worst, std::abs(s.p[at] / 9810 - depth));
  });
  EXPECT_LT(worst, 1e-6) << scheme_names[scheme];
}

TEST(StillPoolWithSolids, StaysStillIn2D) {
  for (const int scheme : {pic, flip, rpic, apic, aflip})
    for (const Splitting splitting : {Splitting::lie, Splitting::midpoint, Splitting::reflection})
      expect_still<2>(32, scheme, splitting, 1e-9);
}

TEST(StillPoolWithSolids, StaysStillIn3D) {
  expect_still<3>(16, apic, Splitting::lie, 1e-9);
}

/// Cut cells that hold no particle are liquid where the cells beside them do.
TEST(StillPoolWithSolids, StaysStillWithAVoxelSurface) {
  Settings s = box({32, 32, 32}, 1.0 / 32);
  s.fluid.surface = Surface::voxel;
  const std::vector<Obstacle> obstacles{{make_half_space(at(0.5, 0.23), at(0.31, 1))}};
  Flow<2> flow(s, seed_around<2>(s, obstacles, [](const auto& x) { return x[1] < 0.75; }), 1, obstacles);
  flow.run_to(0.5);
  EXPECT_LT(flow.max_speed(), 1e-9);
}

} // namespace
} // namespace flipbook::test
