// SPDX-License-Identifier: MIT
// The sweep that asks each particle's material: plastic flow, then the stress that acts in the next step, the elastic
// energy and the speed of waves.
#pragma once

#include "sim/mpm/mpm_state.h"

namespace flipbook {

/// Writes F and memory where the material flows, and V0 tau. The speed is that of the fastest longitudinal wave of any
/// particle. Throws InvertedError for the first particle in their order whose det F is not positive although its
/// material needs that.
template <int Dim, class Real> [[nodiscard]] MaterialTotals ask_materials(MpmState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
