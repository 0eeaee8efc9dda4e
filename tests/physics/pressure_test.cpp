// SPDX-License-Identifier: MIT
// The pressure solve against a dense least-squares solution.
#include "tests/physics/arrangement.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

template <int Dim, class Real = double>
void expect_agreement(int n, double share, Wall wall, PressureSolver solver, std::uint64_t seed) {
  constexpr bool single = std::is_same_v<Real, float>;
  Arrangement<Dim, Real> a(n, seed, share, wall);
  a.settings.pressure.solver = solver;
  constexpr double density = 900, dt = 0.03;
  std::vector<std::size_t> at_row;
  const Eigen::VectorXd expected = a.reference(density, dt, at_row);
  Field<double> p;
  Projection<Dim, Real> project;
  const SolveReport report = project(a.grid, a.walls, a.cells, a.settings.pressure, density, dt, a.u, p, a.pool);
  EXPECT_LE(report.residual, single ? 1e-7 : 1e-12);
  EXPECT_EQ(report.stalls, 0);
  double worst = 0;
  for (std::size_t k = 0; k < at_row.size(); ++k)
    worst = std::max(worst, std::abs(p[at_row[k]] - expected[static_cast<Eigen::Index>(k)]));
  // In single precision the right-hand side is rounded at 6e-8, times the condition of the matrix, about 1e4.
  EXPECT_LT(worst, (single ? 1e-3 : 1e-8) * expected.lpNorm<Eigen::Infinity>()) << Dim << "D, share " << share;
}

struct Case {
  double share;
  Wall wall;
  PressureSolver solver;
};

class PressureSolvers : public testing::TestWithParam<Case> {};

TEST_P(PressureSolvers, AgreeWithDenseSolution) {
  const auto [share, wall, solver] = GetParam();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    expect_agreement<2>(14, share, wall, solver, seed);
    expect_agreement<3>(6, share, wall, solver, seed);
    expect_agreement<2, float>(14, share, wall, solver, seed);
    expect_agreement<3, float>(6, share, wall, solver, seed);
  }
}

/// Boxes that are odd on coarse levels, so that cells of one colour meet across the periodic sides, and on the finest.
TEST(Pressure, AgreesWithDenseSolutionInOddBoxes) {
  for (const double share : {0.7, 1.0}) {
    expect_agreement<2>(26, share, Wall::periodic, PressureSolver::multigrid, 4);
    expect_agreement<3>(10, share, Wall::periodic, PressureSolver::multigrid, 4);
    expect_agreement<2>(27, share, Wall::free_slip, PressureSolver::multigrid, 4);
    expect_agreement<3>(9, share, Wall::free_slip, PressureSolver::multigrid, 4);
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const PressureSolver solver :
       {PressureSolver::multigrid, PressureSolver::mic, PressureSolver::cg, PressureSolver::eigen})
    for (const double share : {0.3, 0.6, 1.0})
      for (const Wall wall : {Wall::free_slip, Wall::periodic}) all.push_back({share, wall, solver});
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, PressureSolvers, testing::ValuesIn(cases()));

template <int Dim> double largest_divergence(const Arrangement<Dim>& a) {
  double worst = 0;
  each_in(a.grid, cells_of(a.grid), [&](const Index<Dim>&, std::size_t at) {
    if (a.cells.fluid[at]) worst = std::max(worst, std::abs(divergence(a.grid, a.walls, a.u, at)));
  });
  return worst;
}

TEST(Projection, RemovesTheDivergenceOfOpenLiquid) {
  Arrangement<2> a(40, 7, 0.7, Wall::free_slip);
  Arrangement<3> b(12, 7, 0.7, Wall::free_slip);
  // A liquid cell without an open face to anywhere is a pocket of its own that nothing can help; here every face is
  // open.
  for (auto& f : a.walls.open)
    for (double& open : f) open = open > 0 ? open : 0.5;
  for (auto& f : b.walls.open)
    for (double& open : f) open = open > 0 ? open : 0.5;
  Field<double> pa, pb;
  const double before = largest_divergence(a);
  Projection<2, double>()(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, a.u, pa, a.pool);
  Projection<3, double>()(b.grid, b.walls, b.cells, b.settings.pressure, 1000, 0.01, b.u, pb, b.pool);
  EXPECT_GT(before, 1);
  EXPECT_LT(largest_divergence(a), 1e-9 * before);
  EXPECT_LT(largest_divergence(b), 1e-9 * before);
}

TEST(Projection, FirstGuessSavesIterationsAndChangesNothing) {
  Arrangement<2> a(32, 3, 0.8, Wall::free_slip);
  const auto u = a.u;
  Field<double> p;
  Projection<2, double> project;
  const auto cold = project(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, a.u, p, a.pool);
  const Field<double> first = p;
  a.u = u;
  const auto warm = project(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, a.u, p, a.pool);
  EXPECT_GT(cold.iterations, 5);
  EXPECT_EQ(warm.iterations, 0);
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(p.data(), static_cast<Eigen::Index>(p.size())) -
             Eigen::Map<const Eigen::VectorXd>(first.data(), static_cast<Eigen::Index>(first.size())))
                .lpNorm<Eigen::Infinity>(),
            1e-6);
}

TEST(Projection, NothingToDoReturnsAtOnce) {
  Arrangement<2> a(8, 3, 1, Wall::free_slip);
  for (auto& f : a.u) std::fill(f.begin(), f.end(), 0.0);
  for (auto& f : a.walls.u_solid) std::fill(f.begin(), f.end(), 0.0);
  Field<double> p;
  const auto report =
      Projection<2, double>()(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, a.u, p, a.pool);
  EXPECT_EQ(report.iterations, 0);
  for (const double x : p) EXPECT_EQ(x, 0);
}

TEST(Projection, StopsAtTheLimitAndSaysHowFarItCame) {
  Arrangement<2> a(32, 3, 0.9, Wall::free_slip);
  a.settings.pressure.max_iterations = 3;
  Field<double> p;
  const auto report =
      Projection<2, double>()(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, a.u, p, a.pool);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_GT(report.residual, 1e-6);
  EXPECT_LT(report.residual, 1);
}

} // namespace
} // namespace flipbook::test
