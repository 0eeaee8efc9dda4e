// SPDX-License-Identifier: MIT
#include "sim/boundary/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace flipbook {
namespace {

using Triple = std::array<double, 3>;

Triple vertex(const TriangleMesh& mesh, std::uint32_t v) {
  return {static_cast<double>(mesh.vertices[3 * v]), static_cast<double>(mesh.vertices[3 * v + 1]),
          static_cast<double>(mesh.vertices[3 * v + 2])};
}

/// Six times the volume between a triangle and the origin: positive in sum if it turns counter-clockwise from outside.
double six_volumes(const Triple& a, const Triple& b, const Triple& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    sum += six_volumes(vertex(mesh, mesh.triangles[i]), vertex(mesh, mesh.triangles[i + 1]),
                       vertex(mesh, mesh.triangles[i + 2]));
  return sum / 6;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Triple a = vertex(mesh, mesh.triangles[i]), b = vertex(mesh, mesh.triangles[i + 1]),
                 c = vertex(mesh, mesh.triangles[i + 2]);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    EXPECT_GE(twice, -1e-9);
    sum += twice / 2;
  }
  return sum;
}

/// Every edge is there once in each direction.
bool closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.triangles[i + k], mesh.triangles[i + (k + 1) % 3]}];
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    const auto back = edges.find({e.first.second, e.first.first});
    return e.second == 1 && back != edges.end() && back->second == 1;
  });
}

/// The distance from a point to the nearest vertex.
double to_vertex(const TriangleMesh& mesh, const Triple& p) {
  double nearest = 1e300;
  for (std::uint32_t v = 0; v < mesh.vertices.size() / 3; ++v) {
    const Triple q = vertex(mesh, v);
    nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return nearest;
}

double off_surface(const TriangleMesh& mesh, const Shape& shape, const Domain& domain) {
  double worst = 0;
  for (std::uint32_t v = 0; v < mesh.vertices.size() / 3; ++v)
    worst = std::max(worst, std::abs(shape.distance(vertex(mesh, v), domain)));
  return worst;
}

const Domain space{3, {1, 1, 1}}, plane{2, {1, 1, 1}};

std::shared_ptr<const TriangleMesh> of(const ShapePtr& shape, const Domain& domain) {
  return solid_surface({shape}, domain, {});
}

TEST(Surface, OfABallIsRound) {
  const auto ball = make_ball({{0.5, 0.45, 0.55}, 3}, 0.3);
  const auto mesh = of(ball, space);
  EXPECT_TRUE(closed(*mesh));
  EXPECT_NEAR(volume(*mesh), 4 * std::numbers::pi / 3 * 0.027, 1e-4);
  EXPECT_LT(off_surface(*mesh, *ball, space), 2e-4);
  EXPECT_GT(mesh->triangles.size(), 3U * 10000);
}

TEST(Surface, OfABoxHasItsEdgesAndCorners) {
  const Triple lo{0.21, 0.13, 0.3}, hi{0.83, 0.47, 0.9};
  const auto box = make_box({lo, 3}, {hi, 3});
  const auto mesh = of(box, space);
  EXPECT_TRUE(closed(*mesh));
  EXPECT_NEAR(volume(*mesh), 0.62 * 0.34 * 0.6, 1e-6);
  EXPECT_LT(off_surface(*mesh, *box, space), 1e-6);
  for (int corner = 0; corner < 8; ++corner) {
    Triple p;
    for (std::size_t d = 0; d < 3; ++d) p[d] = corner >> d & 1 ? hi[d] : lo[d];
    EXPECT_LT(to_vertex(*mesh, p), 1e-6);
  }
}

TEST(Surface, OfCutShapesHasTheirCreases) {
  const auto ball = make_ball({{0.5, 0.5, 0.5}, 3}, 0.3);
  const auto half = make_intersection({ball, make_half_space({{0.5, 0.52, 0.5}, 3}, {{0, 1, 0}, 3})});
  const auto mesh = of(half, space);
  EXPECT_TRUE(closed(*mesh));
  EXPECT_LT(off_surface(*mesh, *half, space), 5e-4);
  const double h = 0.32; // of the spherical cap
  EXPECT_NEAR(volume(*mesh), std::numbers::pi * h * h * (0.3 - h / 3), 2e-4);
}

/// What is infinite ends at the domain, whichever way it lies.
TEST(Surface, OfAHalfSpaceEndsAtTheDomain) {
  const auto floor = make_half_space({{0, 0.25}, 2}, {{0, 1}, 2});
  const auto slope = make_half_space({{0.5, 0.5}, 2}, {{-1, 1}, 2});
  EXPECT_NEAR(volume(*of(floor, space)), 0.25, 1e-6);
  EXPECT_TRUE(closed(*of(slope, space)));
  EXPECT_NEAR(volume(*of(slope, space)), 0.5, 1e-4);
  EXPECT_NEAR(area(*of(slope, plane)), 0.5, 1e-4);
  EXPECT_TRUE(of(make_half_space({{0, -1}, 2}, {{0, 1}, 2}), space)->vertices.empty()) << "nothing of it is there";
}

TEST(Surface, OfMovingShapesIsWhole) {
  const auto outside = make_ball({{-0.5, 0.5, 0.5}, 3}, 0.2);
  EXPECT_TRUE(of(outside, space)->vertices.empty());
  const auto motion = make_motion([](double t) { return Displacement{{0.4 * std::sin(t), 0, 0}, 0}; }, {0, 0, 1}, {});
  EXPECT_NEAR(volume(*solid_surface({outside, motion}, space, {})), 4 * std::numbers::pi / 3 * 0.008, 1e-4);
  // A wall that moves to the right by 0.4 and back still fills the domain to the left of it.
  const auto wall = make_half_space({{0.1, 0}, 2}, {{1, 0}, 2});
  EXPECT_NEAR(volume(*solid_surface({wall, motion}, space, {})), 0.5, 1e-4);
}

/// Its images across the side show what the domain cuts off.
TEST(Surface, GoesOnAcrossAPeriodicSide) {
  const Obstacle ball{make_ball({{0, 0.05, 0.5}, 3}, 0.2)};
  const double whole = 4 * std::numbers::pi / 3 * 0.008, h = 0.15; // of the cap below y = 0
  const double cap = std::numbers::pi * h * h * (0.2 - h / 3);
  EXPECT_NEAR(volume(*solid_surface(ball, space, {true, false, false})), whole - cap, 1e-4);
  EXPECT_NEAR(volume(*solid_surface(ball, space, {true, true, false})), whole, 1e-4);
  EXPECT_NEAR(area(*solid_surface({make_ball({{1, 0.5}, 2}, 0.2)}, plane, {true, false, false})),
              std::numbers::pi * 0.04, 1e-4);
  const Obstacle floor{make_half_space({{0, 0.25}, 2}, {{0, 1}, 2})};
  EXPECT_NEAR(volume(*solid_surface(floor, space, {true, false, true})), 0.25, 1e-6) << "what is infinite ends";
}

TEST(Surface, InThePlaneIsFilledAndOutlined) {
  const auto outline = [](const TriangleMesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.outline.size(); i += 2) {
      const Triple a = vertex(mesh, mesh.outline[i]), b = vertex(mesh, mesh.outline[i + 1]);
      sum += std::hypot(a[0] - b[0], a[1] - b[1]);
    }
    return sum;
  };
  const auto disc = of(make_ball({{0.5, 0.4}, 2}, 0.3), plane);
  EXPECT_NEAR(area(*disc), std::numbers::pi * 0.09, 1e-4);
  EXPECT_NEAR(outline(*disc), 2 * std::numbers::pi * 0.3, 1e-3);

  const auto box = of(make_box({{0.21, 0.13}, 2}, {{0.83, 0.47}, 2}), plane);
  EXPECT_NEAR(area(*box), 0.62 * 0.34, 1e-6);
  EXPECT_NEAR(outline(*box), 2 * (0.62 + 0.34), 1e-5);
  for (const auto& p : {Triple{0.21, 0.13, 0}, {0.83, 0.13, 0}, {0.83, 0.47, 0}, {0.21, 0.47, 0}})
    EXPECT_LT(to_vertex(*box, p), 1e-6);

  const auto ring = of(make_difference({make_ball({{0.5, 0.5}, 2}, 0.4), make_ball({{0.5, 0.5}, 2}, 0.3)}), plane);
  EXPECT_NEAR(area(*ring), std::numbers::pi * 0.07, 1e-4);
  EXPECT_NEAR(outline(*ring), 2 * std::numbers::pi * 0.7, 2e-3);
}

TEST(Bounds, AreThoseOfTheShape) {
  const auto expect = [](const ShapePtr& shape, const Point& lo, const Point& hi) {
    const Bounds b = shape->bounds(space);
    for (std::size_t d = 0; d < 3; ++d) {
      if (std::isfinite(lo[d])) {
        EXPECT_NEAR(b.lo[d], lo[d], 1e-12);
      }
      if (std::isfinite(hi[d])) {
        EXPECT_NEAR(b.hi[d], hi[d], 1e-12);
      }
      EXPECT_EQ(std::isfinite(lo[d]), std::isfinite(b.lo[d]));
      EXPECT_EQ(std::isfinite(hi[d]), std::isfinite(b.hi[d]));
    }
  };
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto ball = make_ball({{0.5, 0.4}, 2}, 0.1), disc = make_disc({{0.2, 0.3}, 2}, 0.1);
  expect(ball, {0.4, 0.3, 0.4}, {0.6, 0.5, 0.6});
  expect(disc, {0.1, 0.2, -none}, {0.3, 0.4, none});
  expect(make_box({{0, 0}, 2}, {{1, 2}, 2}), {0, 0, -none}, {1, 2, none});
  expect(make_capsule({{0.1, 0.2}, 2}, {{0.4, 0.1}, 2}, 0.05), {0.05, 0.05, 0.45}, {0.45, 0.25, 0.55});
  expect(make_half_space({{0, 0.3}, 2}, {{0, -2}, 2}), {-none, 0.3, -none}, {none, none, none});
  expect(make_half_space({{0, 0.3}, 2}, {{1, 1}, 2}), {-none, -none, -none}, {none, none, none});
  expect(make_union({ball, disc}), {0.1, 0.2, -none}, {0.6, 0.5, none});
  expect(make_intersection({ball, disc}), {0.4, 0.3, 0.4}, {0.3, 0.4, 0.6});
  expect(make_difference({ball, disc}), {0.4, 0.3, 0.4}, {0.6, 0.5, 0.6});
}

} // namespace
} // namespace flipbook
