// SPDX-License-Identifier: MIT
// Fluid-implicit-particle: the particle takes the grid's change of velocity, blended with PIC by flip_ratio.
//   P2G  (m u)_i = sum_p w_ip m_p v_p
//   G2P  v_p <- sum_i w_ip u_i + flip_ratio (v_p - sum_i w_ip u_old_i)
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Flip {
  static constexpr std::string_view name = "flip", label = "FLIP";
  static constexpr std::string_view summary = "The particle takes the grid's change of velocity: lively and noisy";
  static constexpr bool parameter_in_title = true; ///< "FLIP 1": readers use both conventions for the number

  double flip_ratio = 1;

  void describe(ParameterVisitor& v) { v.real(flip_ratio_spec, flip_ratio); }
  [[nodiscard]] Corner corner() const { return {.flip_ratio = flip_ratio}; }
};

} // namespace flipbook
