// SPDX-License-Identifier: MIT
// The pressure projection: finds p with div (u - dt/rho grad p) = 0 on every liquid cell, then
//   u_f <- u_f - dt / (rho dx) (p_upper - p_lower) / theta_f
// on every open face of a liquid cell; p = 0 in air.
#pragma once

#include "sim/fluid/pcg.h"

namespace flipbook {

template <int Dim, class Real> class Projection {
public:
  /// Makes u free of divergence. `p` (Pa, at cell centres, pads included) is the first guess and becomes the
  /// pressure; in double, because differences of rounded pressures would bring divergence back.
  SolveReport operator()(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
                         const PressureSettings& settings, double density, double dt, Components<Dim, Real>& u,
                         Field<double>& p, Pool& pool);

private:
  PressureSystem<Dim, Real> system_;
  PressureCg<Dim, Real> cg_;
  std::vector<double> rows_; ///< p on the rows of the system
};

} // namespace flipbook
