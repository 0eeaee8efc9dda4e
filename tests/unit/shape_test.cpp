// SPDX-License-Identifier: MIT
#include "sim/boundary/shape.h"

#include "sim/core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace flipbook {
namespace {

const Domain plane{2, {4, 2, 1}}, space{3, {4, 2, 6}};

std::vector<std::pair<std::string, ShapePtr>> exact_shapes() {
  return {{"box", make_box({{1, 0.5, 0}, 2}, {{2, 1.5, 0}, 2})},
          {"box in 3D", make_box({{1, 0.5, 2}, 3}, {{2, 1.5, 3}, 3})},
          {"ball", make_ball({{2, 1, 0}, 2}, 0.7)},
          {"disc", make_disc({{2, 1, 0}, 2}, 0.7)},
          {"capsule", make_capsule({{1, 0.5, 0}, 2}, {{3, 1.5, 0}, 2}, 0.3)},
          {"half-space", make_half_space({{0, 1, 0}, 2}, {{1, 2, 0}, 2})}};
}

Point random_point(const Domain& domain, std::uint64_t i) {
  Point p{0, 0, 0};
  for (std::size_t d = 0; d < static_cast<std::size_t>(domain.dim); ++d) p[d] = domain.size[d] * uniform(7, i, d);
  return p;
}

/// |grad d| = 1 wherever the gradient exists: central differences at random points, a few of which meet a ridge.
TEST(Shapes, AreDistances) {
  constexpr double h = 1e-6;
  for (const Domain& domain : {plane, space})
    for (const auto& [name, shape] : exact_shapes()) {
      int ridges = 0;
      for (std::uint64_t i = 0; i < 500; ++i) {
        const Point p = random_point(domain, i);
        double squared = 0;
        for (std::size_t d = 0; d < static_cast<std::size_t>(domain.dim); ++d) {
          Point a = p, b = p;
          a[d] -= h, b[d] += h;
          const double slope = (shape->distance(b, domain) - shape->distance(a, domain)) / (2 * h);
          squared += slope * slope;
        }
        if (std::abs(squared - 1) > 1e-6) ++ridges;
      }
      EXPECT_LE(ridges, 2) << name << " in " << domain.dim << "D";
    }
}

TEST(Shapes, HaveTheDistancesOfGeometry) {
  const Point p{3, 2, 1};
  EXPECT_DOUBLE_EQ(make_box({{1, 0, 0}, 2}, {{2, 1, 0}, 2})->distance(p, plane), std::sqrt(2)) << "to a corner";
  EXPECT_DOUBLE_EQ(make_box({{1, 0, 0}, 2}, {{2, 1, 0}, 2})->distance({1.5, 0.75, 0}, plane), -0.25);
  EXPECT_DOUBLE_EQ(make_ball({{0, 2, 0}, 2}, 1)->distance(p, plane), 2);
  EXPECT_DOUBLE_EQ(make_half_space({{0, 0.5, 0}, 2}, {{0, 3, 0}, 2})->distance(p, plane), 1.5);
  EXPECT_DOUBLE_EQ(make_capsule({{0, 0, 0}, 2}, {{4, 0, 0}, 2}, 0.5)->distance(p, plane), 1.5);
  EXPECT_DOUBLE_EQ(make_capsule({{1, 1, 0}, 2}, {{1, 1, 0}, 2}, 0.5)->distance({1, 1, 0}, plane), -0.5) << "no length";
}

TEST(Shapes, SpanTheDomainAlongAnUnlistedAxis) {
  const ShapePtr box = make_box({{1, 0.5, 0}, 2}, {{2, 1.5, 0}, 2});
  const ShapePtr half = make_half_space({{0, 1, 0}, 2}, {{0, 1, 0}, 2});
  const ShapePtr disc = make_disc({{2, 1, 0}, 2}, 0.5);
  for (const double z : {0.0, 0.1, 3.0, 6.0})
    for (const ShapePtr& s : {box, half, disc})
      EXPECT_DOUBLE_EQ(s->distance({1.8, 0.9, z}, space), s->distance({1.8, 0.9, 0}, plane)) << z;
}

TEST(Shapes, PutAPointInTheMiddleOfAnUnlistedAxis) {
  const ShapePtr ball = make_ball({{2, 1, 0}, 2}, 0.5);
  EXPECT_DOUBLE_EQ(ball->distance({2, 1, 3}, space), -0.5);
  EXPECT_DOUBLE_EQ(ball->distance({2, 1, 0}, space), 2.5);
  EXPECT_DOUBLE_EQ(ball->distance({2, 1, 0}, plane), -0.5) << "the third axis does not exist in 2D";
  EXPECT_EQ((Listed{{1, 0, 0}, 0}.in(space)), (Point{2, 1, 3}));
}

TEST(Shapes, CombineAsSets) {
  const ShapePtr a = make_ball({{1.5, 1, 0}, 2}, 0.8), b = make_ball({{2.3, 1, 0}, 2}, 0.8),
                 c = make_ball({{2, 1.4, 0}, 2}, 0.3);
  int inside = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Point p = random_point(plane, i);
    const bool in_a = a->contains(p, plane), in_b = b->contains(p, plane), in_c = c->contains(p, plane);
    inside += in_a && in_b && in_c ? 1 : 0;
    EXPECT_EQ(make_union({a, b, c})->contains(p, plane), in_a || in_b || in_c);
    EXPECT_EQ(make_intersection({a, b, c})->contains(p, plane), in_a && in_b && in_c);
    EXPECT_EQ(make_difference({a, b, c})->contains(p, plane), in_a && !in_b && !in_c);
  }
  EXPECT_GT(inside, 10) << "the case is worth looking at";
}

} // namespace
} // namespace flipbook
