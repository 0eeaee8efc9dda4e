// SPDX-License-Identifier: MIT
// How much liquid there is by its level set: the share of the domain where phi < 0, phi linear between cell centres,
// which is the surface that the pressure sees.
#pragma once

#include "sim/fluid/fluid_state.h"

namespace flipbook {

/// Volume (m^3; m^2 in 2D) outside of obstacles. The surface within half a cell counts as a plane: exact where it lies
/// along an axis.
template <int Dim, class Real> [[nodiscard]] double liquid_volume(const FluidState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
