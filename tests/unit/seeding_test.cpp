// SPDX-License-Identifier: MIT
#include "sim/scene/seeding.h"

#include "sim/core/random.h"
#include "sim/scene/read_scene.h"
#include "tests/unit/message.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace flipbook {
namespace {

const std::string full = "grid.size = [2, 1]\ngrid.cells = [16, 8]\n"
                         "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [2, 1]\n";

template <int Dim> Grid<Dim> grid_of(const Scene& scene) {
  Grid<Dim> g;
  for (int d = 0; d < Dim; ++d) g.cells[d] = scene.settings.grid.cells[static_cast<std::size_t>(d)];
  g.dx = scene.settings.dx();
  return g;
}

template <int Dim, class Real> Particles<Dim, Real> seed(const std::string& text, const std::string& extra = "") {
  std::string all = extra + "\n" + text;
  if (Dim == 3) all = "dim = 3\n" + all;
  const Scene scene = parse_scene(all, "test.toml");
  return seed_particles<Dim, Real>(scene, grid_of<Dim>(scene));
}

template <int Dim> void expect_one_in_each_sub_cell(int per_axis, const std::string& pattern) {
  const auto p = seed<Dim, double>(full, "seeding.per_axis = " + std::to_string(per_axis) + "\nseeding.pattern = \"" +
                                             pattern + "\"");
  std::set<std::vector<long>> cells;
  for (std::size_t i = 0; i < p.size(); ++i) {
    std::vector<long> sub;
    for (int d = 0; d < Dim; ++d) {
      const double s = p.position(i)[d] * 8 * per_axis;
      sub.push_back(std::lround(std::floor(s)));
      if (pattern == "regular") {
        EXPECT_NEAR(s - std::floor(s), 0.5, 1e-9);
      }
    }
    cells.insert(sub);
  }
  const std::size_t expected =
      static_cast<std::size_t>(std::lround(16 * 8 * (Dim == 3 ? 8 : 1) * std::pow(per_axis, Dim)));
  EXPECT_EQ(p.size(), expected);
  EXPECT_EQ(cells.size(), expected) << "two particles share a sub-cell";
}

TEST(Seeding, PutsOneParticleInEachSubCell) {
  for (const int per_axis : {1, 2, 3})
    for (const char* pattern : {"regular", "jittered"}) {
      expect_one_in_each_sub_cell<2>(per_axis, pattern);
      expect_one_in_each_sub_cell<3>(per_axis, pattern);
    }
}

TEST(Seeding, CountsIdsInTheOrderOfTheCells) {
  const auto p = seed<2, double>(full);
  ASSERT_EQ(p.size(), 512U);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_EQ(p.id[i], i);
    const std::size_t cell = i / 4;
    EXPECT_EQ(std::floor(p.position(i)[0] * 8), static_cast<double>(cell % 16));
    EXPECT_EQ(std::floor(p.position(i)[1] * 8), static_cast<double>(cell / 16));
  }
}

/// Sum of the masses = density x area (or volume) of the full domain.
TEST(Seeding, GivesTheMassOfTheFluid) {
  for (const int per_axis : {1, 2, 4}) {
    const auto extra = "fluid.density = 700\nseeding.per_axis = " + std::to_string(per_axis);
    double plane = 0, space = 0;
    for (const double m : seed<2, double>(full, extra).m) plane += m;
    for (const double m : seed<3, double>(full, extra).m) space += m;
    EXPECT_NEAR(plane, 700 * 2 * 1, 1e-9);
    EXPECT_NEAR(space, 700 * 2 * 1 * 1, 1e-9);
  }
}

TEST(Seeding, IsTheSameInEitherPrecisionButForRounding) {
  const auto a = seed<2, float>(full);
  const auto b = seed<2, double>(full);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(a.position(i)[d], b.position(i)[d], 2e-7);
}

TEST(Seeding, DependsOnTheSeedAndOnNothingElse) {
  const auto a = seed<2, double>(full), again = seed<2, double>(full), b = seed<2, double>(full, "seeding.seed = 2");
  EXPECT_EQ(a.x, again.x);
  EXPECT_NE(a.x, b.x);
  // A body that covers half of the domain keeps the particles that it keeps.
  const auto half = seed<2, double>("grid.size = [2, 1]\ngrid.cells = [16, 8]\n[[body]]\nshape = \"box\"\nlo = [0, 0]\n"
                                    "hi = [2, 0.5]\n");
  ASSERT_EQ(half.size(), a.size() / 2);
  EXPECT_TRUE(std::equal(half.x[0].begin(), half.x[0].end(), a.x[0].begin()));
}

TEST(Seeding, StaysInsideTheDomainInSinglePrecision) {
  const auto p = seed<2, float>("grid.size = [0.3, 0.1]\ngrid.cells = [96, 32]\nseeding.per_axis = 8\n"
                                "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [1, 1]\n");
  for (std::size_t i = 0; i < p.size(); ++i) {
    ASSERT_GE(p.position(i)[0], 0.0F);
    ASSERT_LT(p.position(i)[0], 0.3F);
    ASSERT_LT(p.position(i)[1], 0.1F);
  }
}

TEST(Seeding, LetsTheFirstBodyDecideTheVelocity) {
  const auto p =
      seed<2, double>("[[body]]\nshape = \"half_space\"\npoint = [0, 0.5]\nnormal = [0, 1]\nvelocity = [1, 2]\n"
                      "[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [1, 1]\nvelocity = { rotation = 3 }\n");
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto x = p.position(i), v = p.velocity(i);
    const bool lower = x[1] < 0.5;
    EXPECT_DOUBLE_EQ(v[0], lower ? 1 : -3 * (x[1] - 0.5));
    EXPECT_DOUBLE_EQ(v[1], lower ? 2 : 3 * (x[0] - 0.5)) << "about the middle of the domain";
  }
}

TEST(Seeding, KnowsTheMotionsByName) {
  const std::string box = "[[body]]\nshape = \"box\"\nlo = [0, 0, 0]\nhi = [1, 1, 1]\nvelocity = ";
  const auto strain = seed<3, double>(box + "{ strain = 2, centre = [0.5, 0.25] }", "grid.cells = [4, 4]");
  const auto spin = seed<3, double>(box + "{ rotation = [1, 2, 3] }", "grid.cells = [4, 4]");
  const auto swirl = seed<3, double>(box + "{ swirl = \"2*r\" }", "grid.cells = [4, 4]");
  const auto formula = seed<3, double>(box + "[\"x + 2*y\", 1, \"z > 0.5 ? pi : e\"]", "grid.cells = [4, 4]");
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const auto x = strain.position(i);
    const Vec<3, double> r = x - Vec<3, double>(0.5, 0.5, 0.5);
    const Vec<3, double> omega(1, 2, 3);
    EXPECT_LT((strain.velocity(i) - Vec<3, double>(2 * (x[0] - 0.5), -2 * (x[1] - 0.25), 0)).norm(), 1e-14);
    EXPECT_LT((spin.velocity(i) - omega.cross(r)).norm(), 1e-14);
    EXPECT_LT((swirl.velocity(i) - Vec<3, double>(-2 * r[1], 2 * r[0], 0)).norm(), 1e-14);
    EXPECT_LT((formula.velocity(i) - Vec<3, double>(x[0] + 2 * x[1], 1, x[2] > 0.5 ? M_PI : M_E)).norm(), 1e-14);
  }
}

/// Fixed by its seed, within its bound, continuous, and the same on both sides of the domain.
TEST(Seeding, RandomVelocitiesAreContinuousAndPeriodic) {
  const Domain domain{3, {1, 2, 0.5}, {}};
  const auto v = random_velocity(3, 0.1, 7), other = random_velocity(3, 0.1, 8);
  double largest = 0, mean_square = 0, along = 0;
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) {
    const auto number = [&](std::uint64_t c) { return uniform(5, static_cast<std::uint64_t>(i), c); };
    const Point x{number(0), 2 * number(1), 0.5 * number(2)}, there = v->at(x, domain);
    const Point beyond = v->at({x[0] + 1, x[1] - 2, x[2] + 0.5}, domain),
                near = v->at({x[0] + 1e-9, x[1], x[2]}, domain);
    for (std::size_t d = 0; d < 3; ++d) {
      largest = std::max(largest, std::abs(there[d]));
      mean_square += there[d] * there[d] / (3 * n);
      EXPECT_NEAR(beyond[d], there[d], 1e-12);
      EXPECT_NEAR(near[d], there[d], 1e-6);
    }
    along += there[0] * there[1] / n; // components know nothing of each other
    EXPECT_NE(other->at(x, domain), there);
  }
  EXPECT_LE(largest, 3);
  EXPECT_GT(largest, 2);
  // 9/3 at the corners; the mean square of a linear interpolation is 2/3 of that on each axis.
  EXPECT_NEAR(mean_square, 3 * 8.0 / 27, 0.1);
  EXPECT_NEAR(along, 0, 0.1);
  EXPECT_EQ(v->at({0.1, 0.2, 0}, {2, {1, 2, 0.5}, {}})[2], 0) << "none out of the plane";
}

TEST(Seeding, RefusesNoneAndTooMany) {
  EXPECT_EQ(message_of([] { (void)seed<2, float>("[[body]]\nshape = \"ball\"\ncentre = [5, 5]\nradius = 1\n"); }),
            "scene \"test\": no particle starts inside the domain");
  EXPECT_EQ(message_of([] {
              (void)seed<2, float>("grid.cells = [11584, 11584]\nseeding.per_axis = 8\n[[body]]\nshape = \"ball\"\n"
                                   "centre = [0, 0]\nradius = 1\n");
            }),
            "grid.cells and seeding.per_axis make 8588099584 places for particles; at most 4294967296 are supported");
}

/// Mean 1/2 and variance 1/12 of numbers that are uniform in (0, 1), within 5 standard errors; neighbours uncorrelated.
TEST(Random, IsUniformInItsCounters) {
  constexpr int n = 100000;
  double sum = 0, squares = 0, neighbours = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = uniform(1, i, 0) - 0.5;
    ASSERT_GT(u, -0.5);
    ASSERT_LT(u, 0.5);
    sum += u;
    squares += u * u;
    neighbours += u * (uniform(1, i, 1) - 0.5);
  }
  EXPECT_NEAR(sum / n, 0, 5 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(squares / n, 1.0 / 12, 5 * std::sqrt(1.0 / 180 / n));
  EXPECT_NEAR(neighbours / n, 0, 5 / 12.0 / std::sqrt(n));
}

/// The published first outputs of SplitMix64 with state 1234567.
TEST(Random, MixesAsSplitMix64) {
  EXPECT_EQ(mix(1234567), 6457827717110365317ULL);
  EXPECT_EQ(mix(1234567 + 0x9e3779b97f4a7c15ULL), 3203168211198807973ULL);
}

} // namespace
} // namespace flipbook
