// SPDX-License-Identifier: MIT
// The particles at the start of round trips. What a scheme remembers besides v_p is gathered from the velocity of the
// scene itself, sampled on the grid, not from what P2G makes of the particles: an affine velocity then begins exactly
// affine, whatever the seeding, also at the edge of a body.
#pragma once

#include "sim/scene/scene.h"
#include "sim/transfer_only/trip_state.h"

namespace flipbook {

/// Seeded, in cell order, with v_start, A and what P2G leaves on the grid. Particles of files without a velocity in the
/// scene have none but their own: their A is gathered from the grid. Throws UserError as seed_particles() does, and
/// where the velocity of a body cannot be computed at a sample that particles reach.
template <int Dim, class Real> [[nodiscard]] TripState<Dim, Real> start_of_trips(const Scene& scene, Pool& pool);

} // namespace flipbook
