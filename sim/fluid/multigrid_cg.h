// SPDX-License-Identifier: MIT
// Conjugate gradients for the pressure equation with one multigrid cycle as the preconditioner:
//   z = M r,  s <- z + (z.r / z_0.r_0) s,  alpha = z.r / s.A s,  p <- p + alpha s,  r = b - A p
// p and b are in double. So is the residual, which is computed anew from them each time: what is left of it after
// rounding to single precision is enough for directions z and s, since errors in these cost convergence, not accuracy.
// A double run therefore reaches 1e-13 with the same single-precision cycle as a single run reaches 1e-6.
#pragma once

#include "sim/core/profile.h"
#include "sim/fluid/pressure_lattice.h"
#include "sim/fluid/solve_report.h"

namespace flipbook {

/// What is asked of multigrid, so that it counts as getting nearer: the least residual of `iterations` is below
/// `factor` times the least one before them. It mostly gains a factor of five in each, plain conjugate gradients two in
/// ten.
struct Progress {
  int iterations = 10;
  double factor = 0.5;
};

template <int Dim, class Real> class MultigridCg {
public:
  /// Improves p, the first guess, until the residual is below the tolerance, or gives up with `stalled`. A right-hand
  /// side of zero gives p = 0 at once. The profile is told when the coarse levels are made.
  SolveReport solve(PressureLattice<Dim, Real>& lattice, const PressureSettings& settings, const Progress& progress,
                    Coloured<double>& p, Pool& pool, Profile* profile = nullptr);

private:
  using Lattice = PressureLattice<Dim, Real>;
  double find_residual(Lattice& lattice, const Coloured<double>& p, Pool& pool);
  bool step(Lattice& lattice, Coloured<double>& p, Pool& pool);
  [[nodiscard]] double rounding(Lattice& lattice, const Coloured<double>& p, Pool& pool) const;

  double norm_b_ = 0;
  double sigma_ = 0; ///< z.r, 0 before the first step
  Coloured<float> s_;
};

} // namespace flipbook
