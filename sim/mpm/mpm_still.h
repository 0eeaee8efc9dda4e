// SPDX-License-Identifier: MIT
// What a step of the material point method holds after a stage, for whoever looks (sim/frame/stage_still.h).
#pragma once

#include "sim/fluid/still.h"
#include "sim/mpm/mpm_state.h"

namespace flipbook {

template <int Dim, class Real> [[nodiscard]] StageStill mpm_still(const StillOf& of, const MpmState<Dim, Real>& state) {
  StageStill still = still_of_particles(of, state.grid, state.particles);
  add_velocity(still, state.grid, Layout::nodes, state.m, state.u);
  return still;
}

} // namespace flipbook
