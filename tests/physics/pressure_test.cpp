// SPDX-License-Identifier: MIT
// The pressure solve against a dense least-squares solution by Eigen, from a matrix that is built here from the
// definition.
#include "tests/physics/flow.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

/// A random arrangement of liquid, air and partly open faces, with moving solids and a random velocity.
template <int Dim> struct Arrangement {
  Settings settings;
  Grid<Dim> grid;
  Walls<Dim, double> walls;
  Cells<Dim, double> cells;
  Components<Dim, double> u;
  Budget budget{1};
  Pool pool{budget};
  Budget::Permit permit{budget};

  Arrangement(int n, std::uint64_t seed, double share_of_liquid, Wall wall)
      : settings(with_walls(n, wall)), grid(grid_of<Dim>(settings)), walls(grid, settings.walls) {
    cells.fluid.assign(static_cast<std::size_t>(grid.size()), 0);
    each_in(grid, cells_of(grid),
            [&](const Index<Dim>&, std::size_t at) { cells.fluid[at] = uniform(seed, at, 0) < share_of_liquid; });
    walls.wrap_cells(cells.fluid);
    cells.inverse_theta.resize(grid);
    u.resize(grid);
    for (int a = 0; a < Dim; ++a) fill_faces(a, seed);
  }

  static Settings with_walls(int n, Wall wall) {
    Settings s = box({n, n, n}, 0.1, Dim);
    s.walls.axis.fill(wall);
    s.pressure.tolerance = 1e-13;
    return s;
  }

  void fill_faces(int a, std::uint64_t seed) {
    const auto axis = static_cast<std::size_t>(a);
    each_in(grid, faces_of(grid, a), [&](const Index<Dim>& i, std::size_t at) {
      const auto lower = at - static_cast<std::size_t>(grid.stride(a));
      const auto home = static_cast<std::size_t>(grid.at(walls.image(i))); // the same on both sides of a periodic box
      const auto random = [&](std::uint64_t k) { return uniform(seed + 1 + axis, home, k); };
      u[axis][at] = 2 * random(0) - 1;
      walls.u_solid[axis][at] = 2 * random(1) - 1;
      if (walls.open[axis][at] > 0) walls.open[axis][at] = random(2) < 0.2 ? 0 : random(3);
      if (cells.fluid[at] || cells.fluid[lower])
        cells.inverse_theta[axis][at] = cells.fluid[at] == cells.fluid[lower] ? 1 : 1 / (0.01 + 0.99 * random(4));
    });
  }

  /// The pressures at the liquid cells, by the definition of the equation.
  [[nodiscard]] Eigen::VectorXd reference(double density, double dt, std::vector<std::size_t>& at_row) const {
    std::vector<int> row(cells.fluid.size(), -1);
    each_in(grid, cells_of(grid), [&](const Index<Dim>&, std::size_t at) {
      if (cells.fluid[at]) row[at] = static_cast<int>(at_row.size()), at_row.push_back(at);
    });
    const auto n = static_cast<Eigen::Index>(at_row.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    each_in(grid, cells_of(grid), [&](const Index<Dim>& i, std::size_t at) {
      if (!cells.fluid[at]) return;
      for (int a = 0; a < Dim; ++a)
        for (const int side : {0, 1}) {
          Index<Dim> face = i, beyond = i;
          face[a] += side;
          beyond[a] += 2 * side - 1;
          const auto f = static_cast<std::size_t>(grid.at(face));
          const auto axis = static_cast<std::size_t>(a);
          const double open = walls.open[axis][f], weight = open * cells.inverse_theta[axis][f];
          const double flux = open * u[axis][f] + (1 - open) * walls.u_solid[axis][f];
          b[row[at]] -= (2 * side - 1) * flux * density * grid.dx / dt;
          const auto j = static_cast<std::size_t>(grid.at(walls.image(beyond)));
          A(row[at], row[at]) += weight;
          if (row[j] >= 0) A(row[at], row[j]) -= weight;
        }
    });
    // The shortest of the least-squares solutions: its mean is zero in closed pockets, whatever the sum of b there.
    return A.completeOrthogonalDecomposition().solve(b);
  }
};

template <int Dim> void expect_agreement(int n, double share, Wall wall, PressureSolver solver, std::uint64_t seed) {
  Arrangement<Dim> a(n, seed, share, wall);
  a.settings.pressure.solver = solver;
  constexpr double density = 900, dt = 0.03;
  std::vector<std::size_t> at_row;
  const Eigen::VectorXd expected = a.reference(density, dt, at_row);
  Field<double> p;
  Projection<Dim, double> project;
  const SolveReport report = project(a.grid, a.walls, a.cells, a.settings.pressure, density, dt, a.u, p, a.pool);
  EXPECT_LE(report.residual, 1e-12);
  double worst = 0;
  for (std::size_t k = 0; k < at_row.size(); ++k)
    worst = std::max(worst, std::abs(p[at_row[k]] - expected[static_cast<Eigen::Index>(k)]));
  EXPECT_LT(worst, 1e-8 * expected.lpNorm<Eigen::Infinity>()) << Dim << "D, share " << share;
}

struct Case {
  double share;
  Wall wall;
  PressureSolver solver;
};

class Pressure : public testing::TestWithParam<Case> {};

TEST_P(Pressure, AgreesWithDenseSolution) {
  const auto [share, wall, solver] = GetParam();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    expect_agreement<2>(14, share, wall, solver, seed);
    expect_agreement<3>(6, share, wall, solver, seed);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Pressure,
    testing::Values(Case{0.6, Wall::free_slip, PressureSolver::mic}, Case{0.6, Wall::free_slip, PressureSolver::cg},
                    Case{0.6, Wall::periodic, PressureSolver::mic}, Case{1.0, Wall::free_slip, PressureSolver::mic},
                    Case{1.0, Wall::free_slip, PressureSolver::cg}, Case{1.0, Wall::periodic, PressureSolver::mic}));

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
  EXPECT_LE(warm.iterations, 1);
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
