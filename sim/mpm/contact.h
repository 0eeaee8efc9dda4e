// SPDX-License-Identifier: MIT
// What walls and obstacles do to the velocity of the grid's nodes that they hold. With the velocity U of what stands
// there, its normal n out of it, and u_n = (u - U) . n:
//   sticky      u = U
//   slip        u <- u - u_n n
//   separating  where u_n < 0:  u <- U + t max(0, 1 - friction |u_n| / |t|),  t = u - U - u_n n; else nothing
// the last with Coulomb's law: what is pressed on it by an impulse m |u_n| loses at most friction times that along it.
#pragma once

#include "sim/mpm/mpm_state.h"

namespace flipbook {

/// Obstacles must be placed and have their velocity.
template <int Dim, class Real> void apply_contact(MpmState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
