// SPDX-License-Identifier: MIT
// What multigrid promises: a coarse matrix that is Galerkin's, a symmetric positive cycle, as many iterations on a fine
// grid as on a coarse one, whatever the liquid looks like, and a way out where it comes no nearer.
#include "tests/physics/arrangement.h"

#include "sim/fluid/history.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

/// body(colour, place, number of the cell) for every cell of a board.
template <int Dim, class Body> void each_cell(const Checkerboard<Dim>& board, Body&& body) {
  std::size_t number = 0;
  for (std::int64_t r = 0; r < board.rows(); ++r) {
    const auto row = board.row(r);
    for (int x = 0; x < board.n[0]; ++x) body(row.colour(x), row.place(x), number++);
  }
}

/// v.A v on a level.
template <int Dim> double energy(const PressureLevel<Dim>& level, Coloured<float> v, Pool& pool) {
  level.board.fill_pads(v, pool);
  double sum = 0;
  level.each_piece(pool, [&](const Piece& piece) {
    for (const int colour : {0, 1})
      Apply(level.board, level.A, level.full, v, colour)(piece, [&](int i, float Av) {
        const std::ptrdiff_t at = piece.at + i;
        if (level.inverse_d.of(colour)[at] > 0) sum += static_cast<double>(v.of(colour)[at]) * static_cast<double>(Av);
      });
  });
  return sum;
}

template <int Dim, class Real> struct OnLattice {
  Arrangement<Dim, Real> a;
  PressureLattice<Dim, Real> lattice;

  OnLattice(int n, Wall wall, std::uint64_t seed, double share = 0.8) : a(n, seed, share, wall) {
    lattice.assemble(a.grid, a.walls, a.cells, a.u, 1000, 0.01, a.pool);
    lattice.multigrid().coarsen(a.pool);
  }
  [[nodiscard]] Multigrid<Dim>& multigrid() { return lattice.multigrid(); }
};

/// P^T A P: a coarse vector has the energy of the fine one that has its values.
template <int Dim> void expect_galerkin(int n, Wall wall) {
  OnLattice<Dim, float> on(n, wall, 5);
  Multigrid<Dim>& multigrid = on.multigrid();
  ASSERT_GT(multigrid.levels(), 2u);
  for (std::size_t l = 0; l + 1 < multigrid.levels(); ++l) {
    const auto &fine = multigrid.level(l), &coarse = multigrid.level(l + 1);
    Coloured<float> x, Px;
    x.resize(coarse.board.half);
    Px.resize(fine.board.half);
    each_cell(coarse.board, [&](int colour, std::ptrdiff_t at, std::size_t k) {
      x.of(colour)[at] = static_cast<float>(uniform(l, k, 0) - 0.5);
    });
    for (std::int64_t r = 0; r < fine.board.rows(); ++r) {
      const auto row = fine.board.row(r);
      std::int64_t above = 0;
      for (int d = Dim - 1; d > 0; --d) above = above * coarse.board.n[d] + row.cell[d] / 2;
      const auto up = coarse.board.row(above);
      for (int i = 0; i < fine.board.n[0]; ++i)
        Px.of(row.colour(i))[row.place(i)] = x.of(up.colour(i / 2))[up.place(i / 2)];
    }
    const double expected = energy(fine, Px, on.a.pool);
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(energy(coarse, x, on.a.pool), expected, 1e-5 * expected) << Dim << "D, " << n << ", level " << l;
  }
}

TEST(Multigrid, CoarseMatricesAreGalerkins) {
  for (const Wall wall : {Wall::free_slip, Wall::periodic})
    for (const int n : {32, 36, 44}) expect_galerkin<2>(n, wall);
  for (const Wall wall : {Wall::free_slip, Wall::periodic})
    for (const int n : {12, 14}) expect_galerkin<3>(n, wall);
  expect_galerkin<2>(37, Wall::free_slip);
  expect_galerkin<3>(13, Wall::free_slip);
}

/// x.M y = y.M x and x.M x > 0, where x and y have the mean zero in closed pockets.
template <int Dim> void expect_symmetric(int n, Wall wall, double share) {
  OnLattice<Dim, float> on(n, wall, 6, share);
  const auto& level = on.lattice.level();
  const auto random = [&](std::uint64_t seed) {
    Coloured<double> f;
    f.resize(level.board.half);
    each_cell(level.board, [&](int colour, std::ptrdiff_t at, std::size_t k) {
      if (level.inverse_d.of(colour)[at] > 0) f.of(colour)[at] = uniform(seed, k, 0) - 0.5;
    });
    on.lattice.pockets().remove_means(f, on.a.pool);
    return f;
  };
  const auto preconditioned = [&](const Coloured<double>& f) {
    auto& finest = on.multigrid().finest();
    each_cell(level.board, [&](int colour, std::ptrdiff_t at, std::size_t) {
      finest.b.of(colour)[at] = static_cast<float>(f.of(colour)[at]);
    });
    on.multigrid().cycle(on.a.pool);
    return finest.x;
  };
  const auto dot = [&](const Coloured<double>& f, const Coloured<float>& g) {
    double sum = 0;
    each_cell(level.board, [&](int colour, std::ptrdiff_t at, std::size_t) {
      sum += f.of(colour)[at] * static_cast<double>(g.of(colour)[at]);
    });
    return sum;
  };
  const auto x = random(1), y = random(2);
  const auto Mx = preconditioned(x), My = preconditioned(y);
  const double xMx = dot(x, Mx), yMy = dot(y, My);
  EXPECT_GT(xMx, 0);
  EXPECT_GT(yMy, 0);
  EXPECT_NEAR(dot(x, My), dot(y, Mx), 1e-5 * std::sqrt(xMx * yMy)) << Dim << "D, " << n << ", share " << share;
}

TEST(Multigrid, TheCycleIsSymmetricAndPositive) {
  for (const Wall wall : {Wall::free_slip, Wall::periodic})
    for (const double share : {0.5, 0.8, 1.0}) {
      expect_symmetric<2>(44, wall, share);
      expect_symmetric<3>(12, wall, share);
      expect_symmetric<3>(20, wall, share);
    }
}

// === Liquids of all shapes

enum class Shape { block, waves, puddles, lonely, layer, full };

template <int Dim> Settings box_of(int n, Shape shape) {
  std::array<int, 3> cells{n, shape == Shape::layer ? 3 : n, n};
  return Arrangement<Dim>::with_walls(cells, Wall::free_slip);
}

template <int Dim, class Real> Arrangement<Dim, Real> liquid(int n, Shape shape) {
  const auto inside = [&](const Index<Dim>& cell, double random) {
    const double x = (cell[0] + 0.5) / n, y = (cell[1] + 0.5) / n;
    switch (shape) {
    case Shape::block: return x < 0.4 && y < 0.8;
    case Shape::waves: return y < 0.4 + 0.2 * std::sin(9 * x);
    case Shape::puddles: return y < 0.25 || random < 0.1;
    case Shape::lonely: return cell.sum() % 2 == 0 && random < 0.9;
    case Shape::layer: return cell[1] == 0;
    case Shape::full: return true;
    }
    return false;
  };
  return Arrangement<Dim, Real>(8, box_of<Dim>(n, shape), inside);
}

/// A solve from p = 0 with the tolerance of single precision, or that of double.
template <int Dim, class Real>
SolveReport solve(Arrangement<Dim, Real>& a, PressureSolver solver, double tolerance, Field<double>& p) {
  a.settings.pressure.solver = solver;
  a.settings.pressure.tolerance = tolerance;
  auto u = a.u;
  return Projection<Dim, Real>()(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, u, p, a.pool);
}

template <int Dim, class Real> void expect_the_pressure_of_mic(int n, Shape shape) {
  constexpr bool single = std::is_same_v<Real, float>;
  auto a = liquid<Dim, Real>(n, shape);
  Field<double> p, q;
  const SolveReport report = solve(a, PressureSolver::multigrid, single ? 1e-7 : 1e-11, p);
  solve(a, PressureSolver::mic, single ? 1e-7 : 1e-11, q);
  EXPECT_EQ(report.stalls, 0);
  EXPECT_LE(report.residual, single ? 1e-7 : 1e-11);
  EXPECT_LE(report.iterations, single ? 25 : 32); // every face is open by another random fraction
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    worst = std::max(worst, std::abs(p[i] - q[i]));
    largest = std::max(largest, std::abs(q[i]));
  }
  // The residual times the condition of the matrix, up to 1e5 with faces that are open by 1e-4.
  EXPECT_LT(worst, (single ? 1e-2 : 1e-6) * largest) << Dim << "D, shape " << static_cast<int>(shape);
}

TEST(Multigrid, FindsThePressureOfAnyLiquid) {
  for (const Shape shape : {Shape::block, Shape::waves, Shape::puddles, Shape::lonely, Shape::layer, Shape::full}) {
    expect_the_pressure_of_mic<2, float>(75, shape);
    expect_the_pressure_of_mic<2, double>(64, shape);
    expect_the_pressure_of_mic<3, float>(24, shape);
    expect_the_pressure_of_mic<3, double>(21, shape);
  }
}

/// A block of liquid with its surface in the middle between two cells, falling: no obstacles, so that all resolutions
/// show the same problem.
template <int Dim> int iterations(int n) {
  auto a = liquid<Dim, float>(n, Shape::block);
  a.walls = Walls<Dim, float>(a.grid, a.settings.walls);
  for (int d = 0; d < Dim; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    for (auto& inverse_theta : a.cells.inverse_theta[axis])
      if (inverse_theta > 1) inverse_theta = 2;
    std::fill(a.u[axis].begin(), a.u[axis].end(), d == 1 ? -1.0f : 0.0f);
    a.walls.close(a.u, a.pool);
  }
  Field<double> p;
  const SolveReport report = solve(a, PressureSolver::multigrid, 1e-6, p);
  EXPECT_LE(report.residual, 1e-6);
  return report.iterations;
}

TEST(Multigrid, NeedsAsManyIterationsForFineGridsAsForCoarseOnes) {
  const int in_plane = iterations<2>(32), in_space = iterations<3>(16);
  EXPECT_LE(in_plane, 8);
  EXPECT_LE(in_space, 8);
  for (const int n : {64, 128, 256}) EXPECT_NEAR(iterations<2>(n), in_plane, 2) << n;
  for (const int n : {32, 64}) EXPECT_NEAR(iterations<3>(n), in_space, 2) << n;
}

// === The way out

TEST(Multigrid, ThatComesNoNearerLeavesTheRestToMic) {
  auto a = liquid<2, double>(64, Shape::waves);
  Field<double> p, q;
  solve(a, PressureSolver::mic, 1e-10, q);
  a.settings.pressure.solver = PressureSolver::multigrid;
  Projection<2, double> project;
  project.progress = {1, 1e-6}; // more than it can do
  auto u = a.u;
  SolveReport report = project(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, u, p, a.pool);
  EXPECT_TRUE(report.stalled);
  EXPECT_EQ(report.stalls, 1);
  EXPECT_LE(report.residual, 1e-10);
  EXPECT_GT(report.iterations, 30); // those of MIC(0) as well
  const auto pressure = [](const Field<double>& f) {
    return Eigen::Map<const Eigen::VectorXd>(f.data(), static_cast<Eigen::Index>(f.size()));
  };
  EXPECT_LT((pressure(p) - pressure(q)).norm(), 1e-6 * pressure(q).norm());
  EXPECT_EQ(warnings(report), std::vector<std::string>{"multigrid stalled in 1 pressure solve, which MIC(0) conjugate "
                                                       "gradients finished"});
  project.progress = {};
  std::fill(p.begin(), p.end(), 0.0);
  u = a.u;
  report = project(a.grid, a.walls, a.cells, a.settings.pressure, 1000, 0.01, u, p, a.pool);
  EXPECT_FALSE(report.stalled);
  EXPECT_EQ(report.stalls, 1); // of the run
  EXPECT_TRUE(warnings(SolveReport{}).empty());
}

TEST(Multigrid, StopsWhereRoundingLeavesNothingToGain) {
  auto a = liquid<2, double>(64, Shape::waves);
  Field<double> p;
  const SolveReport report = solve(a, PressureSolver::multigrid, 1e-16, p);
  EXPECT_FALSE(report.stalled);
  EXPECT_LT(report.iterations, 60);
  EXPECT_LT(report.residual, 1e-11);
}

} // namespace
} // namespace flipbook::test
