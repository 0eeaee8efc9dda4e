// SPDX-License-Identifier: MIT
// Somebody who is called at both borders of every stage of a step and may change what is there. The ledger looks
// outside of these calls, so a change belongs to the stage that it was made in. A normal run has none.
#pragma once

#include "sim/fluid/fluid_state.h"
#include "sim/fluid/stage.h"

namespace flipbook {

template <int Dim, class Real> class StageHook {
public:
  virtual ~StageHook() = default;
  virtual void entered(Stage stage, FluidState<Dim, Real>& state) = 0;
  virtual void leaving(Stage stage, FluidState<Dim, Real>& state) = 0;
};

} // namespace flipbook
