// SPDX-License-Identifier: MIT
// The one family that every scheme is a corner of:
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + A_p (x_i - x_p))
//   G2P  v_p <- sum_i w_ip u_i + flip_ratio (v_p - sum_i w_ip u_old_i),   A_p <- affine * (what the mode gathers from
//   u)
// so a run can slide from one scheme to another by moving numbers.
#pragma once

#include "sim/core/particles.h"

namespace flipbook {

struct Corner {
  AffineMode mode = AffineMode::none;
  double flip_ratio = 0; ///< in [0, 1]: 1 pure FLIP, 0 pure PIC
  double affine = 1;     ///< in [0, 1]: scales what the mode gathers
  bool skew = false;     ///< full mode: keep the antisymmetric part of C only
};

} // namespace flipbook
