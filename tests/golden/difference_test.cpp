// SPDX-License-Identifier: MIT
// A minus B: nothing between equals, and the known number between what is known.
#include "render/views/difference.h"
#include "tests/golden/bodies.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipbook::test {
namespace {

using render::DifferenceField;
using render::DifferenceOf;

constexpr std::array<DifferenceOf, 3> quantities{DifferenceOf::speed, DifferenceOf::density, DifferenceOf::surface};

/// A box of cells with two particles on each axis of every cell where inside(x), in the middles of its halves.
Snapshot filled(int dim, std::array<int, 3> cells, double dx, const std::function<bool(const Vec3&)>& inside) {
  Vec3 hi{1, 1, 1};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) hi[a] = cells[a] * dx;
  Snapshot s = empty_tank(dim, {0, 0, 0}, hi);
  s.cells = cells;
  s.dx = dx;
  if (dim == 2) s.cells[2] = 1;
  add_particles(s, dx / 2, inside);
  return s;
}

Snapshot pool(int dim, std::array<int, 3> cells, double dx, double height) {
  return filled(dim, cells, dx, [=](const Vec3& x) { return x[1] < height; });
}

void set_velocity(Snapshot& s, const Vec3& v) {
  for (std::size_t i = 0; i < s.v.size(); ++i) s.v[i] = static_cast<float>(v[i % static_cast<std::size_t>(s.dim)]);
}

DifferenceField between(const Snapshot& a, const Snapshot& b, DifferenceOf of) {
  const auto f = render::difference_field(a, b, of);
  EXPECT_TRUE(f.has_value());
  return f.value_or(DifferenceField{});
}

TEST(Difference, OfIdenticalPanesIsExactlyNothing) {
  for (const char* name : {"dam_flip", "dam_3d"})
    for (const DifferenceOf of : quantities) {
      const DifferenceField f = between(*stored(name), *stored(name), of);
      EXPECT_EQ(f.rms, 0) << name;
      EXPECT_EQ(f.bulk, 0) << name;
      std::size_t defined = 0;
      for (const float x : f.value) {
        EXPECT_TRUE(std::isnan(x) || x == 0);
        defined += std::isnan(x) ? 0 : 1;
      }
      EXPECT_GT(defined, 50U) << name;
    }
}

TEST(Difference, ChangesItsSignWithTheOrder) {
  for (const DifferenceOf of : quantities) {
    const DifferenceField ab = between(*stored("dam_flip"), *stored("dam_pic"), of),
                          ba = between(*stored("dam_pic"), *stored("dam_flip"), of);
    EXPECT_EQ(ab.rms, ba.rms);
    EXPECT_GT(ab.rms, 0);
    for (std::size_t i = 0; i < ab.value.size(); ++i)
      EXPECT_TRUE(std::isnan(ab.value[i]) || ab.value[i] == -ba.value[i]) << i;
  }
}

/// |v| = 1.25 against |v| = 0.75, in every cell.
TEST(Difference, OfSpeedsIsThatOfTheirMeans) {
  for (const int dim : {2, 3}) {
    Snapshot a = pool(dim, {8, 8, 4}, 0.125, 0.5), b = a;
    set_velocity(a, {0.75, -1, 0});
    set_velocity(b, {0, 0.75, 0});
    const DifferenceField f = between(a, b, DifferenceOf::speed);
    EXPECT_NEAR(f.rms, 0.5, 1e-6) << "in single precision";
    EXPECT_NEAR(f.bulk, 0.5, 1e-6);
  }
}

/// Where only one has liquid a speed has nothing to be compared with.
TEST(Difference, OfSpeedsIsDefinedWhereBothAre) {
  Snapshot a = pool(2, {8, 8, 1}, 0.125, 0.5), b = pool(2, {8, 8, 1}, 0.125, 0.25);
  set_velocity(a, {1, 0, 0});
  const DifferenceField f = between(a, b, DifferenceOf::speed);
  for (std::size_t i = 0; i < f.value.size(); ++i) EXPECT_EQ(std::isnan(f.value[i]), i >= 16) << i; // rows 0 and 1
  EXPECT_NEAR(f.rms, 1, 1e-6);
  const Snapshot none = empty_tank(2, {0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(std::isnan(between(a, none, DifferenceOf::speed).rms)) << "nothing in common";
}

/// Full against empty is 1 in the cells that one has more; at the surface a row is shared with the linear weights: of
/// a cell's particles those in its upper half give a quarter to the cell above. With heights of 2 and 4 cells the rows
/// have 1, 7/8, 1/8, 0, 0 and 1, 1, 1, 7/8, 1/8: the differences are 0, -1/8, -7/8, -7/8, (-1/8, outside both).
TEST(Difference, OfDensitiesIsThatOfTheLinearWeights) {
  const Snapshot a = pool(2, {8, 8, 1}, 0.125, 0.25), b = pool(2, {8, 8, 1}, 0.125, 0.5);
  const DifferenceField f = between(a, b, DifferenceOf::density);
  const std::array<double, 4> rows{0, -1.0 / 8, -7.0 / 8, -7.0 / 8};
  double sum = 0;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_NEAR(static_cast<double>(f.value[i + 8 * j]), rows[j], 1e-6) << i << " " << j;
    sum += rows[j] * rows[j] / 4;
  }
  EXPECT_TRUE(std::isnan(f.value[8 * 4])) << "neither has liquid there";
  EXPECT_NEAR(f.rms, std::sqrt(sum), 1e-6);
}

/// Two level pools: everywhere the depth below the surface differs by the difference of their heights.
TEST(Difference, OfSurfacesIsHowFarTheyAreApart) {
  for (const int dim : {2, 3}) {
    const Snapshot a = pool(dim, {16, 16, 6}, 0.0625, 0.5), b = pool(dim, {16, 16, 6}, 0.0625, 0.3125);
    const DifferenceField f = between(a, b, DifferenceOf::surface);
    EXPECT_NEAR(f.rms, 0.1875, 1e-5);
    for (const float x : f.value)
      if (!std::isnan(x)) {
        EXPECT_NEAR(static_cast<double>(x), 0.1875, 1e-5) << "more of A";
      }
  }
  const Snapshot full = pool(2, {8, 8, 1}, 0.125, 2), half = pool(2, {8, 8, 1}, 0.125, 0.5);
  EXPECT_TRUE(std::isnan(between(full, half, DifferenceOf::surface).rms)) << "a full tank has no surface";
}

/// 16 cells against 32: the same uniform flow differs in nothing; the grid is the finer one.
TEST(Difference, ComparesGridsOfDifferentCells) {
  Snapshot coarse = pool(2, {16, 16, 1}, 0.0625, 0.5), fine = pool(2, {32, 32, 1}, 0.03125, 0.5);
  set_velocity(coarse, {1, 0, 0});
  set_velocity(fine, {0.5, 0, 0});
  for (const bool swapped : {false, true}) {
    const DifferenceField f =
        swapped ? between(fine, coarse, DifferenceOf::speed) : between(coarse, fine, DifferenceOf::speed);
    EXPECT_EQ(f.grid.n[0], 32);
    EXPECT_NEAR(f.rms, 0.5, 1e-6);
  }
  const DifferenceField d = between(coarse, fine, DifferenceOf::density);
  EXPECT_NEAR(static_cast<double>(d.value[5 + 32 * 5]), 0, 1e-6) << "inside both";
}

TEST(Difference, NeedsOneDomain) {
  const Snapshot a = pool(2, {8, 8, 1}, 0.125, 0.5), b = pool(2, {8, 16, 1}, 0.125, 0.5),
                 c = pool(3, {8, 8, 8}, 0.125, 0.5);
  EXPECT_FALSE(render::difference_field(a, b, DifferenceOf::speed));
  EXPECT_FALSE(render::difference_field(a, c, DifferenceOf::speed));
  EXPECT_FALSE(render::difference_field(a, a, DifferenceOf::off));
  EXPECT_TRUE(render::same_domain(a, a));
}

/// A disc of radius 0.3: the distance is exact but for O(dx), inside and outside; across a periodic side as well.
TEST(SignedDistance, IsThatFromACircle) {
  render::CellGrid g{2, {64, 64, 1}, {0, 0, 0}, 1.0 / 64, {false, false, false}};
  const auto exact = [](double x, double y) { return std::hypot(x, y) - 0.3; };
  for (const bool periodic : {false, true}) {
    g.periodic = {periodic, periodic, false};
    const double centre = periodic ? 0 : 0.5; // on the corner, seen through all sides
    std::vector<float> phi, truth;
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        double x = (i + 0.5) / 64 - centre, y = (j + 0.5) / 64 - centre;
        if (periodic) x -= std::round(x), y -= std::round(y);
        truth.push_back(static_cast<float>(exact(x, y)));
        phi.push_back(std::clamp(truth.back() * 3, -0.1F, 0.1F)); // no distance, only its zero
      }
    const std::vector<float> d = render::signed_distance(phi, g);
    ASSERT_EQ(d.size(), phi.size());
    for (std::size_t i = 0; i < d.size(); ++i)
      EXPECT_NEAR(static_cast<double>(d[i]), static_cast<double>(truth[i]), 1.0 / 64) << i << " " << periodic;
  }
  EXPECT_TRUE(render::signed_distance(std::vector<float>(64 * 64, 1.F), g).empty());
}

/// The level set is the solvers' own: the distance to the nearest particle less r = (sqrt(2) + sqrt(10)) / 4 spacing.
TEST(Liquid, IsAUnionOfBalls) {
  Snapshot s = empty_tank(2, {0, 0, 0}, {1, 1, 1});
  s.cells = {10, 10, 1};
  s.dx = 0.1;
  add_particle(s, {0.52, 0.31, 0});
  s.particle_spacing = 0.05;
  const std::vector<float> phi = render::liquid(s, render::grid_of(s));
  const double r = (std::sqrt(2.0) + std::sqrt(10.0)) / 4 * 0.05;
  EXPECT_NEAR(static_cast<double>(phi[5 + 10 * 3]), std::hypot(0.03, 0.04) - r, 1e-6);
  EXPECT_NEAR(static_cast<double>(phi[6 + 10 * 3]), std::hypot(0.13, 0.04) - r, 1e-6);
  EXPECT_NEAR(static_cast<double>(phi[0]), 0.1, 1e-6) << "a cell away and farther";
}

} // namespace
} // namespace flipbook::test
