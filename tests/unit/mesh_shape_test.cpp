// SPDX-License-Identifier: MIT
#include "sim/boundary/mesh_shape.h"

#include "sim/boundary/mesh_check.h"
#include "sim/boundary/mesh_tree.h"
#include "sim/boundary/sign_cells.h"
#include "sim/boundary/winding.h"
#include "sim/core/random.h"
#include "tests/unit/mesh_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipbook {
namespace {

using Vector = Vec<3, double>;
const Domain space{3, {4, 4, 4}};

/// Between -1 and 1 times `reach` around a centre.
Point random_point(std::uint64_t i, double reach, const Point& centre = {0, 0, 0}) {
  Point p = centre;
  for (std::size_t d = 0; d < 3; ++d) p[d] += reach * (2 * uniform(3, i, d) - 1);
  return p;
}

ShapePtr shape_of(const Mesh& mesh) {
  return make_mesh_shape(mesh, false);
}

TEST(MeshShape, HasTheDistanceOfABox) {
  const Point lo{1, 0.5, -2}, hi{2, 1.5, -1.25};
  const ShapePtr mesh = shape_of(box_mesh(lo, hi)), box = make_box({lo, 3}, {hi, 3});
  int inside = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Point p = random_point(i, i % 2 == 0 ? 1.0 : 30.0, {1.5, 1, -1.6});
    const double d = box->distance(p, space);
    inside += d < 0 ? 1 : 0;
    ASSERT_NEAR(mesh->distance(p, space), d, 1e-12 * std::max(1.0, std::abs(d)));
    ASSERT_EQ(mesh->contains(p, space), d < 0);
  }
  EXPECT_GT(inside, 500);
}

/// x, y, z >= 0 and x + y + z <= 1: inside, the distance to the nearest of four planes.
TEST(MeshShape, HasTheDistanceOfATetrahedron) {
  const ShapePtr mesh = shape_of(tetrahedron());
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Point p = random_point(i, 0.5, {0.5, 0.5, 0.5});
    const double slanted = (p[0] + p[1] + p[2] - 1) / std::sqrt(3);
    const double d = std::max({-p[0], -p[1], -p[2], slanted});
    if (d < 0) {
      ASSERT_NEAR(mesh->distance(p, space), d, 1e-12);
    } else {
      ASSERT_GE(mesh->distance(p, space), d - 1e-12);
    }
  }
  EXPECT_NEAR(mesh->distance({-3, -4, 0.2}, space), 5, 1e-12) << "to an edge";
  EXPECT_NEAR(mesh->distance({-2, -3, -6}, space), 7, 1e-12) << "to a corner";
  EXPECT_NEAR(mesh->distance({1, 1, 1}, space), 2 / std::sqrt(3), 1e-12) << "to the slanted face";
}

/// Against every triangle one after the other, on a surface with many small ones.
TEST(MeshShape, FindsTheNearestOfAllTriangles) {
  const Mesh mesh = torus_mesh(1, 0.3, 40, 20);
  const ShapePtr all = shape_of(mesh);
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Point p = random_point(i, i % 3 == 0 ? 20.0 : 1.5);
    double nearest = 1e300;
    const auto at = [&](std::uint32_t v) { return Vector(mesh.vertices[v].data()); };
    for (const auto& t : mesh.triangles)
      nearest = std::min(nearest, MeshTree({{at(t[0]), at(t[1]), at(t[2])}}).distance(Vector(p.data())));
    ASSERT_NEAR(std::abs(all->distance(p, space)), nearest, 1e-12 * std::max(1.0, nearest));
  }
}

/// The chords of a sphere of n x m places lie within (pi/m)^2/2 + (pi/n)^2/2 below it.
TEST(MeshShape, IsNearlyASphere) {
  const ShapePtr mesh = shape_of(sphere_mesh(200, 100));
  constexpr double sag = 2e-3;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const Point p = random_point(i, 2);
    const double r = std::hypot(p[0], p[1], p[2]), d = mesh->distance(p, space);
    ASSERT_GE(d, r - 1 - 1e-12);
    ASSERT_LE(d, r - 1 + sag);
  }
}

TEST(MeshShape, KnowsItsSideAtEdgesAndCorners) {
  // A needle-sharp fan: the nearest point of most places is a corner or an edge, whose triangles disagree on the side.
  Mesh star{{{0, 0, 5}, {0, 0, -0.1}}, {}};
  constexpr std::uint32_t n = 12;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double r = k % 2 == 0 ? 2 : 0.2, a = 2 * std::numbers::pi * k / n;
    star.vertices.push_back({r * std::cos(a), r * std::sin(a), 0});
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    star.triangles.push_back({0, 2 + k, 2 + (k + 1) % n});
    star.triangles.push_back({1, 2 + (k + 1) % n, 2 + k});
  }
  const ShapePtr shape = shape_of(star);
  std::vector<MeshTree::Triangle> triangles;
  const auto at = [&](std::uint32_t v) { return Vector(star.vertices[v].data()); };
  for (const auto& t : star.triangles) triangles.push_back({at(t[0]), at(t[1]), at(t[2])});
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto& corner = star.vertices[i % star.vertices.size()];
    const Point p = random_point(i, i % 2 == 0 ? 1e-3 : 1.0, corner);
    double omega = 0;
    for (const auto& t : triangles)
      omega += solid_angle(t.a - Vector(p.data()), t.b - Vector(p.data()), t.c - Vector(p.data()));
    ASSERT_EQ(shape->contains(p, space), omega > 2 * std::numbers::pi) << i;
    ASSERT_EQ(shape->distance(p, space) < 0, omega > 2 * std::numbers::pi) << i;
  }
}

TEST(MeshShape, IsZeroOnItsSurface) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const ShapePtr shape = shape_of(mesh);
  for (const auto& x : mesh.vertices) EXPECT_EQ(shape->distance(x, space), 0);
  EXPECT_EQ(shape->distance({0.25, 0.5, 1}, space), 0) << "on a face";
  EXPECT_EQ(shape->distance({0.5, 0, 0}, space), 0) << "on an edge";
  EXPECT_EQ(shape->distance({0.5, 0.5, 0}, space), 0) << "on the diagonal of a face";
}

TEST(MeshShape, HasCavities) {
  Mesh mesh = box_mesh({0, 0, 0}, {3, 3, 3});
  append(mesh, turned_inside_out(box_mesh({1, 1, 1}, {2, 2, 2})));
  const ShapePtr shape = shape_of(mesh);
  EXPECT_NEAR(shape->distance({1.5, 1.5, 1.5}, space), 0.5, 1e-12) << "in the cavity";
  EXPECT_NEAR(shape->distance({0.25, 1.5, 1.5}, space), -0.25, 1e-12) << "in the wall";
  EXPECT_NEAR(shape->distance({-1, 1.5, 1.5}, space), 1, 1e-12);
}

TEST(MeshShape, IsTheUnionOfOverlappingParts) {
  Mesh mesh = box_mesh({0, 0, 0}, {2, 1, 1});
  append(mesh, box_mesh({1, 0, 0}, {3, 1, 1}));
  const ShapePtr shape = shape_of(mesh);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const Point p = random_point(i, 2, {1.5, 0.5, 0.5});
    const bool inside = p[0] > 0 && p[0] < 3 && p[1] > 0 && p[1] < 1 && p[2] > 0 && p[2] < 1;
    ASSERT_EQ(shape->contains(p, space), inside) << p[0] << " " << p[1] << " " << p[2];
  }
}

/// A plate of 1e-6: every point within has its side from far away as from near.
TEST(MeshShape, MayBeThin) {
  const ShapePtr shape = shape_of(box_mesh({0, 0, 0}, {1, 1, 1e-6}));
  EXPECT_NEAR(shape->distance({0.3, 0.6, 5e-7}, space), -5e-7, 1e-18);
  EXPECT_TRUE(shape->contains({0.3, 0.6, 9e-7}, space));
  EXPECT_FALSE(shape->contains({0.3, 0.6, 1.1e-6}, space));
  EXPECT_FALSE(shape->contains({0.3, 0.6, -1e-7}, space));
}

TEST(MeshShape, LosesNothingFarFromTheOrigin) {
  constexpr double away = 1e6;
  const ShapePtr shape = shape_of(box_mesh({away, away, away}, {away + 1, away + 1, away + 1}));
  EXPECT_NEAR(shape->distance({away + 0.5, away + 0.5, away - 0.25}, space), 0.25, 1e-9);
  EXPECT_NEAR(shape->distance({away + 0.5, away + 0.5, away + 0.125}, space), -0.125, 1e-9);
  EXPECT_NEAR(shape->distance({0, 0, 0}, space), away * std::sqrt(3), 1e-6);
}

/// Sign by regions: everywhere the same as the sum of all solid angles.
TEST(MeshShape, HasOneSideInEachRegion) {
  const Mesh mesh = torus_mesh(1, 0.4, 60, 30);
  const ShapePtr shape = shape_of(mesh);
  int inside = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Point p = random_point(i, 1.5);
    double omega = 0;
    const auto from = [&](std::uint32_t v) -> Vector { return Vector(mesh.vertices[v].data()) - Vector(p.data()); };
    for (const auto& t : mesh.triangles) omega += solid_angle(from(t[0]), from(t[1]), from(t[2]));
    ASSERT_EQ(shape->contains(p, space), omega > 2 * std::numbers::pi);
    inside += omega > 2 * std::numbers::pi ? 1 : 0;
  }
  EXPECT_GT(inside, 150);
}

TEST(MeshShape, StandsInWorldCoordinates) {
  const ShapePtr shape = shape_of(box_mesh({10, 20, 30}, {11, 21, 31}));
  const Domain there{3, {4, 4, 4}, {9, 19, 29}};
  EXPECT_NEAR(shape->distance({1.5, 1.5, 1.25}, there), -0.25, 1e-12);
  const Bounds b = shape->bounds(there);
  EXPECT_EQ(b.lo, (Point{1, 1, 1}));
  EXPECT_EQ(b.hi, (Point{2, 2, 2}));
  EXPECT_EQ(shape->surface(there)->vertices[0], 1.0F);
  EXPECT_EQ(shape->surface(there)->triangles.size(), 36U);
}

TEST(MeshShape, IsCutByTheMiddleIn2D) {
  const Domain plane{2, {4, 4, 1}};
  const ShapePtr low = shape_of(box_mesh({1, 1, 0}, {2, 2, 0.4})), high = shape_of(box_mesh({1, 1, 0}, {2, 2, 0.6}));
  EXPECT_FALSE(low->contains({1.5, 1.5, 0}, plane));
  EXPECT_TRUE(high->contains({1.5, 1.5, 0}, plane));
  const ShapePtr middle = make_mesh_shape(box_mesh({1, 1, -0.1}, {2, 2, 0.1}), true);
  EXPECT_TRUE(middle->contains({1.5, 1.5, 0}, plane)) << "z counts from the middle";
  EXPECT_NEAR(middle->distance({1.5, 1.5, 2}, space), -0.1, 1e-12);
  EXPECT_EQ(middle->surface(plane), nullptr) << "its section is found from the distance";
}

} // namespace
} // namespace flipbook
