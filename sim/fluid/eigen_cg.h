// SPDX-License-Identifier: MIT
// The pressure equation by Eigen's conjugate gradients with its incomplete Cholesky factors, in double: code that
// others wrote, to compare with. It assembles a sparse matrix anew each time and is serial.
#pragma once

#include "sim/fluid/pressure_system.h"
#include "sim/fluid/solve_report.h"
#include "sim/scene/settings.h"

namespace flipbook {

/// Improves p, the first guess, until the residual is below the tolerance.
template <int Dim, class Real>
SolveReport solve_with_eigen(const PressureSystem<Dim, Real>& system, const PressureSettings& settings,
                             std::vector<double>& p);

} // namespace flipbook
