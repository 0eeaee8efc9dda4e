// SPDX-License-Identifier: MIT
// Preconditioned conjugate gradients for the pressure equation, to a relative residual norm |b - A p| / |b|.
// Preconditioners:
//   cg   the diagonal (Jacobi)
//   mic  modified incomplete Cholesky factors without fill, MIC(0): M = (E + L) E^-1 (E + L^T), L the strict lower
//   triangle
//        of A, E such that row sums of M and A agree up to a factor tau = 0.97 on the fill that is dropped [Gustafsson
//        1978]
#pragma once

#include "sim/fluid/pressure_system.h"
#include "sim/fluid/solve_report.h"
#include "sim/scene/settings.h"

namespace flipbook {

template <int Dim, class Real> class PressureCg {
public:
  /// Improves p, the first guess, until the residual is below the tolerance. A right-hand side of zero gives p = 0 at
  /// once.
  SolveReport solve(const PressureSystem<Dim, Real>& system, const PressureSettings& settings, std::vector<double>& p,
                    Pool& pool);

private:
  using System = PressureSystem<Dim, Real>;
  void factorise(const System& system, PressureSolver solver);
  /// z = M^-1 r.
  void precondition(const System& system, PressureSolver solver, Pool& pool);

  std::vector<double> r_, s_, q_;
  std::vector<Real> z_, inverse_e_, upper_; ///< a preconditioner need not be precise
};

} // namespace flipbook
