// SPDX-License-Identifier: MIT
// The pressure projection: finds p with div (u - dt/rho grad p) = 0 on every liquid cell, then
//   u_f <- u_f - dt / (rho dx) (p_upper - p_lower) / theta_f
// on every open face of a liquid cell; p = 0 in air.
#pragma once

#include "sim/core/profile.h"
#include "sim/fluid/multigrid_cg.h"
#include "sim/fluid/pcg.h"

namespace flipbook {

template <int Dim, class Real> class Projection {
public:
  /// Makes u free of divergence. `p` (Pa, at cell centres, pads included) is the first guess and becomes the
  /// pressure; in double, because differences of rounded pressures would bring divergence back.
  SolveReport operator()(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                         const PressureSettings& settings, double density, double dt, Components<Dim, Real>& u,
                         Field<double>& p, Pool& pool);

  Progress progress;          ///< that multigrid must make
  Profile* profile = nullptr; ///< tells the set-up from the solve; null in a normal run

private:
  SolveReport solve_on_lattice(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                               const PressureSettings& settings, double density, double dt,
                               const Components<Dim, Real>& u, Field<double>& p, Pool& pool);
  SolveReport solve_by_rows(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                            const PressureSettings& settings, double density, double dt, const Components<Dim, Real>& u,
                            Field<double>& p, Pool& pool);

  PressureLattice<Dim, Real> lattice_;
  MultigridCg<Dim, Real> multigrid_;
  Coloured<double> coloured_; ///< p on the lattice
  PressureSystem<Dim, Real> system_;
  PressureCg<Dim, Real> cg_;
  std::vector<double> rows_; ///< p on the rows of the system
  int stalls_ = 0;           ///< solves that multigrid did not finish
};

} // namespace flipbook
