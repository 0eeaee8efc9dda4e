// SPDX-License-Identifier: MIT
// The one family that every scheme is a corner of:
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + A_p (x_i - x_p))
//   G2P  v_p <- sum_i w_ip u_i + flip_ratio (v_p - sum_i w_ip u_old_i),   A_p <- affine * (what the mode gathers from
//   u)
//   x_p <- x_p + dt (sum_i w_ip u_i + beta (v_p - sum_i w_ip u_i))   with the new v_p; solids only
// so a run can slide from one scheme to another by moving numbers. A scheme written as plain scalar code is outside of
// the family: it brings its own painting and gathering (scalar.h).
#pragma once

#include "sim/core/particles.h"
#include "sim/frame/parameters.h"

#include <memory>

namespace flipbook {

class ScalarPart;

struct Corner {
  AffineMode mode = AffineMode::none;
  double flip_ratio = 0; ///< in [0, 1]: 1 pure FLIP, 0 pure PIC
  double affine = 1;     ///< in [0, 1]: scales what the mode gathers
  bool skew = false;     ///< full mode: keep the antisymmetric part of C only
  int order = 1;         ///< XPIC's m: terms of the filter that stands for v_p in FLIP's update; 1: none
  /// Share of what v_p holds beyond the grid's velocity that a particle of a solid also moves with (ASFLIP): where the
  /// material holds together, and where it separates.
  double beta_min = 0, beta_max = 0;
  /// Where there is one, it transfers, and of the above only the mode counts: what its particles remember.
  std::shared_ptr<const ScalarPart> scalar{};

  /// Is v_p after G2P the grid's velocity at the particle, sum_i w_ip u_i, to the bit?
  [[nodiscard]] bool v_is_u() const { return flip_ratio == 0 && order == 1 && !scalar; }
};

/// How flip_ratio is described, in every scheme that has it.
inline constexpr Spec flip_ratio_spec{.name = "flip_ratio",
                                      .help = "Share of FLIP in the velocity update. 1: pure FLIP, 0: pure PIC",
                                      .min = 0,
                                      .max = 1,
                                      .level = Level::teach,
                                      .at_min = "PIC",
                                      .at_max = "FLIP"};

/// How affine is described; what it is a share of differs between the modes.
[[nodiscard]] constexpr Spec affine_spec(std::string_view help) {
  return {
      .name = "affine", .help = help, .min = 0, .max = 1, .level = Level::teach, .at_min = "none", .at_max = "full"};
}

} // namespace flipbook
