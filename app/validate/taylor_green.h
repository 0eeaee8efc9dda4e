// SPDX-License-Identifier: MIT
// Runs of Taylor-Green vortices, for the validation case and for figures.
#pragma once

#include "app/validate/experiment.h"

#include <array>

namespace flipbook::app {

/// A kernel and what it predicts.
struct KernelVariance {
  const char* name;
  double variance; ///< D / dx^2; of the linear kernel on the average over a cell
};
inline constexpr std::array<KernelVariance, 3> kernel_variances{
    {{"linear", 1.0 / 6}, {"quadratic", 1.0 / 4}, {"cubic", 1.0 / 3}}};

struct TaylorGreenState {
  double energy = 0; ///< of the grid, relative to the exact one
  double error = 0;  ///< of the velocity, relative
};

/// After `time`, for every set-up and seed, with steps of cfl / cells.
[[nodiscard]] std::vector<std::vector<TaylorGreenState>> run_taylor_green(const std::vector<Setup>& setups, double time,
                                                                          int seeds, const Lab& lab);

/// nu dt / dx^2 for every set-up and seed: from the fall of the energy after the first few steps, in which the kernel
/// smooths what was seeded.
[[nodiscard]] std::vector<std::vector<double>> transfer_viscosity(const std::vector<Setup>& setups, int seeds,
                                                                  const Lab& lab);

} // namespace flipbook::app
