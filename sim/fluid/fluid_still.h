// SPDX-License-Identifier: MIT
// What a liquid's step holds after a stage, for whoever looks (sim/frame/stage_still.h).
#pragma once

#include "sim/fluid/fluid_state.h"
#include "sim/fluid/still.h"

namespace flipbook {

/// `u`: the velocity that the stage left on the grid.
template <int Dim, class Real>
[[nodiscard]] StageStill fluid_still(const StillOf& of, const FluidState<Dim, Real>& state,
                                     const Components<Dim, Real>& u);

} // namespace flipbook
