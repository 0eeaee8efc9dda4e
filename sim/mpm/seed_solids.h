// SPDX-License-Identifier: MIT
// The particles of a scene as solids: undeformed, with the mass and the memory of what their body is made of.
#pragma once

#include "sim/mpm/mpm_state.h"

namespace flipbook {

/// In cell order. Throws UserError as seed_particles() does, and for more than 255 materials.
template <int Dim, class Real> [[nodiscard]] MpmState<Dim, Real> seed_solids(const Scene& scene, Pool& pool);

/// Puts state.material in the order of the particles, which must have been sorted.
template <int Dim, class Real> void follow_order(MpmState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
