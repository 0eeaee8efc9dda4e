// SPDX-License-Identifier: MIT
// The pressure equation (pressure_system.h) on the box around the liquid, as a checkerboard without rows or indices:
// the matrix, the right-hand side, and the closed pockets.
#pragma once

#include "sim/fluid/box.h"
#include "sim/fluid/cells.h"
#include "sim/fluid/multigrid.h"
#include "sim/fluid/pockets.h"
#include "sim/fluid/walls.h"

namespace flipbook {

template <int Dim, class Real> class PressureLattice {
public:
  using Board = Checkerboard<Dim>;

  Coloured<double> b; ///< right-hand side (Pa); its mean in each closed pocket is zero

  void assemble(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                const Components<Dim, Real>& u, double density, double dt, Pool& pool);

  [[nodiscard]] const PressureLevel<Dim>& level() const { return multigrid_.finest(); }
  [[nodiscard]] PressureLevel<Dim>& level() { return multigrid_.finest(); }
  [[nodiscard]] Multigrid<Dim>& multigrid() { return multigrid_; }
  [[nodiscard]] Pockets<Dim>& pockets() { return pockets_; }
  /// The matrix in the precision of the run.
  [[nodiscard]] const Stencil<Dim, Real>& matrix() const {
    if constexpr (std::is_same_v<Real, float>)
      return level().A;
    else
      return exact_;
  }

  /// From a field on the grid, and back; zero outside of the liquid.
  void gather(const Grid<Dim>& grid, const Field<double>& p, Coloured<double>& to, Pool& pool) const;
  void scatter(const Grid<Dim>& grid, const Coloured<double>& from, Field<double>& p, Pool& pool) const;

private:
  void find_box(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells, Pool& pool);
  template <class Body> void each_row(const Grid<Dim>& grid, Pool& pool, Body&& body) const;

  Multigrid<Dim> multigrid_;
  Stencil<Dim, Real> exact_; ///< in double only
  Pockets<Dim> pockets_;
  Index<Dim> corner_ = Index<Dim>::Zero(); ///< the sample of the grid that the box begins with
  std::vector<Box<Dim>> boxes_;            ///< of chunks of rows
};

} // namespace flipbook
