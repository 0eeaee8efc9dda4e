// SPDX-License-Identifier: MIT
// The memory that a phase of a step cannot do without: every array that it must read or write, counted once for each.
// With N particles, S samples of the padded grid, F liquid cells, D axes, R bytes of a Real, A numbers of affine state,
// f = 1 where G2P reads u_old and else 0, k stages of the advection, I iterations of the pressure solve, and for solids
// C numbers that a particle carries besides, T of them its stress:
//
//   sort            2 N (R (2D + 1 + A + C) + 4) + 4 S   every column read and written, the starts of the cells written
//   level set       N D R + S (R + 1 + D R)              x read; phi, the cells and 1/theta written
//   P2G             N R (2D + 1 + A) + 2 S D R           particles read; m and u written
//   extrapolate     4 S D R                              u read and written, twice a step
//   forces          2 S D R                              u read and written
//   pressure set-up 2 S D R + F (8 + R (D + 1))          u and 1/theta read; the right-hand side and the matrix written
//   pressure solve  I F (104 + 2 R (D + 1)) + 2 S D R    13 passes over vectors of doubles, the matrix and its
//                                                        preconditioner; u read and written
//   G2P             N R (2D + f D + A) + (1 + f) S D R   x and with FLIP v read, v and A written; u (and u_old) read
//   advect          k (2 N D R + S D R)                  x read and written, u read
//   advect, solids  N R (2 D + 2 D^2) + S D R            x and F read and written, u read
//   stress          N R (C + 2 T) + ..                   V0, F, memory read, V0 tau written; then x and V0 tau read; f
//                                                        written and read, m read, u written
//   snapshot        N (2 D R + 4 + 8 D + 8)              x, v and id read; x, v, id and a colour written as floats
//
// A phase that reads an array twice, or clears it first, moves more: bytes / time is a lower bound of its bandwidth.
#pragma once

#include "sim/core/profile.h"
#include "sim/scene/settings.h"

namespace flipbook::app {

struct Work {
  double particles = 0, samples = 0; ///< N, S
  double liquid = 0, iterations = 0; ///< F and I of one step
  double snapshots = 0;              ///< of one step
};

/// Bytes of one step; 0 for a phase that has no formula.
[[nodiscard]] double phase_bytes(Phase phase, const Settings& settings, const Work& work);

} // namespace flipbook::app
