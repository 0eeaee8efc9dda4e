// SPDX-License-Identifier: MIT
// Between particles and faces, by trilinear weights w_ip:
//   splat   u_i = sum_p w_ip v_p / sum_p w_ip  where the sum of weights is at least 1e-6, else 0; no masses
//   gather  v_p = u(x_p) + flip_ratio (v_p - u_old(x_p)),  u(x) = sum_i w_i(x) u_i
//   move    x_p <- x_p + dt u(x_p), then clamped to 1e-4 within the solid layer
#pragma once

#include "sim/core/parallel.h"
#include "sim/tutorial/notes_state.h"

namespace flipbook {

/// u(x) of one component.
[[nodiscard]] double interpolate(const NotesGrid& grid, const Faces& u, std::size_t component, const Point3& x);

/// Fills u and u_old, and marks the cells.
void splat(NotesState& state, Pool& pool);
/// Returns the kinetic energy that the grid gained from u_old to u on the particles, all of mass 1:
/// sum_p sum_i w_ip (u_i^2 - u_old_i^2) / 2.
double gather(NotesState& state, double flip_ratio, Pool& pool);
void move(NotesState& state, Pool& pool);

} // namespace flipbook
