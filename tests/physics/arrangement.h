// SPDX-License-Identifier: MIT
// Random arrangements of liquid, air, partly open faces and moving solids, and their pressures by a dense least-squares
// solution of Eigen, from a matrix that is built here from the definition.
#pragma once

#include "tests/physics/flow.h"

#include <Eigen/Dense>

namespace flipbook::test {

/// A random arrangement of liquid, air and partly open faces, with moving solids and a random velocity.
template <int Dim, class Real = double> struct Arrangement {
  Settings settings;
  Grid<Dim> grid;
  Walls<Dim, Real> walls;
  Cells<Dim, Real> cells;
  Components<Dim, Real> u;
  Budget budget{1};
  Pool pool{budget};
  Budget::Permit permit{budget};

  Arrangement(int n, std::uint64_t seed, double share_of_liquid, Wall wall)
      : Arrangement(seed, with_walls({n, n, n}, wall),
                    [&](const Index<Dim>&, double random) { return random < share_of_liquid; }) {}

  /// Liquid where is_liquid(index of the cell, a random number in [0, 1)) holds.
  template <class IsLiquid>
  Arrangement(std::uint64_t seed, const Settings& given, IsLiquid&& is_liquid)
      : settings(given), grid(grid_of<Dim>(settings)), walls(grid, settings.walls) {
    cells.fluid.assign(static_cast<std::size_t>(grid.size()), 0);
    each_in(grid, cells_of(grid), [&](const Index<Dim>& i, std::size_t at) {
      const Index<Dim> cell = i.array() - Grid<Dim>::pad;
      cells.fluid[at] = is_liquid(cell, uniform(seed, at, 0));
    });
    walls.wrap_cells(cells.fluid);
    cells.inverse_theta.resize(grid);
    u.resize(grid);
    for (int a = 0; a < Dim; ++a) fill_faces(a, seed);
  }

  static Settings with_walls(std::array<int, 3> n, Wall wall) {
    Settings s = box(n, 0.1, Dim);
    s.walls.axis.fill(wall);
    s.pressure.tolerance = std::is_same_v<Real, float> ? 1e-7 : 1e-13;
    return s;
  }

  void fill_faces(int a, std::uint64_t seed) {
    const auto axis = static_cast<std::size_t>(a);
    each_in(grid, faces_of(grid, a), [&](const Index<Dim>& i, std::size_t at) {
      const auto lower = at - static_cast<std::size_t>(grid.stride(a));
      const auto home = static_cast<std::size_t>(grid.at(walls.image(i))); // the same on both sides of a periodic box
      const auto random = [&](std::uint64_t k) { return uniform(seed + 1 + axis, home, k); };
      u[axis][at] = static_cast<Real>(2 * random(0) - 1);
      walls.u_solid[axis][at] = static_cast<Real>(2 * random(1) - 1);
      if (walls.open[axis][at] > 0) walls.open[axis][at] = random(2) < 0.2 ? Real(0) : static_cast<Real>(random(3));
      if (cells.fluid[at] || cells.fluid[lower])
        cells.inverse_theta[axis][at] =
            cells.fluid[at] == cells.fluid[lower] ? Real(1) : static_cast<Real>(1 / (0.01 + 0.99 * random(4)));
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
          const double open = static_cast<double>(walls.open[axis][f]),
                       weight = open * static_cast<double>(cells.inverse_theta[axis][f]);
          const double flux =
              open * static_cast<double>(u[axis][f]) + (1 - open) * static_cast<double>(walls.u_solid[axis][f]);
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

} // namespace flipbook::test
