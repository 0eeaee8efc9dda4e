// SPDX-License-Identifier: MIT
// The pressure equation on the liquid cells only, numbered without gaps, x fastest:
//   sum_f open_f (p_i - p_j) / theta_f = -(rho dx / dt) sum_f s_f (open_f u_f + (1 - open_f) u_solid_f)
// over the faces f of cell i, where s_f = +-1 points outwards, j is the neighbour, p_j = 0 in air, and no term stands
// for a closed face. Symmetric and diagonally dominant; p comes out in pascals. Unknowns are in double whatever the
// precision of the run: single cannot hold a residual of 1e-6, because p is larger than the right-hand side by the
// condition of the matrix.
#pragma once

#include "sim/core/field.h"
#include "sim/fluid/cells.h"
#include "sim/fluid/walls.h"

#include <array>
#include <vector>

namespace flipbook {

template <int Dim, class Real> struct PressureSystem {
  static constexpr int sides = 2 * Dim;
  /// One row of the matrix: diagonal p_i - sum_s weight_s p_neighbour_s. A side without a neighbour has weight 0 and
  /// names the row itself. The lower x neighbour comes last, because it is the latest one a sweep has computed.
  struct Row {
    std::array<int, sides> neighbour;
    std::array<Real, sides> weight;
    double diagonal; ///< the exact sum of single-precision weights: a closed pocket stays singular
  };

  std::vector<Row> rows;
  std::vector<double> rhs;
  std::vector<std::size_t> cell; ///< where each row lies in a field
  /// The rows of each closed pocket: liquid that no air touches. Its pressure is known up to a constant, and its
  /// right-hand side must have the mean zero.
  std::vector<std::vector<int>> pockets;

  void assemble(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                const Components<Dim, Real>& u, double density, double dt, Pool& pool);

  /// q = A p.
  void multiply(const std::vector<double>& p, std::vector<double>& q, Pool& pool) const;
  /// Subtracts from the rows of each pocket their mean.
  void remove_pocket_means(std::vector<double>& x) const;

private:
  void number_cells(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells);
  void find_pockets();

  std::vector<int> number_;          ///< row of each cell, -1 where not liquid
  std::vector<std::uint8_t> at_air_; ///< of each row
};

/// div u of each liquid cell in 1/s, solids included; for diagnostics and tests.
template <int Dim, class Real>
[[nodiscard]] Real divergence(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Components<Dim, Real>& u,
                              std::size_t cell) {
  Real flux = 0;
  for (int a = 0; a < Dim; ++a) {
    const auto& open = walls.open[static_cast<std::size_t>(a)];
    const auto& solid = walls.u_solid[static_cast<std::size_t>(a)];
    const auto& ua = u[static_cast<std::size_t>(a)];
    const std::size_t upper = cell + static_cast<std::size_t>(grid.stride(a));
    flux += open[upper] * ua[upper] + (1 - open[upper]) * solid[upper];
    flux -= open[cell] * ua[cell] + (1 - open[cell]) * solid[cell];
  }
  return flux / static_cast<Real>(grid.dx);
}

} // namespace flipbook
