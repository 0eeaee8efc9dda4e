// SPDX-License-Identifier: MIT
// How much of the velocity that the particles began with is left. With v_0 that velocity and <a, b> = sum m_p a_p .
// b_p:
//   residual  = |v - v_0| / |v_0|
//   kept      = <v, v_0> / <v_0, v_0>
// and of the affine velocity that fits v best, v = V + A (x - X), A = W + S with W antisymmetric and S symmetric,
//   kept_rotation = W : W_0 / W_0 : W_0,   kept_strain = S : S_0 / S_0 : S_0.
// Only the velocities v_p count, not what else the scheme remembers.
#pragma once

#include "sim/transfer_only/trip_state.h"

#include <optional>

namespace flipbook {

/// Shares of 1; absent where there was none at the start, or too little to be told from rounding.
struct Kept {
  std::optional<double> residual, kept;
  std::optional<double> rotation, strain; ///< absent with a periodic axis too: nothing affine is periodic
};

template <int Dim, class Real> [[nodiscard]] Kept kept(const TripState<Dim, Real>& state, Pool& pool);

} // namespace flipbook
