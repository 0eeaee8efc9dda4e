// SPDX-License-Identifier: MIT
// Affine particle-in-cell [Jiang et al. 2015]: the particle carries a locally affine velocity.
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + C_p (x_i - x_p))
//   G2P  v_p <- sum_i w_ip u_i,   C_p <- affine sum_i u_i (D_p^-1 w_ip (x_i - x_p))^T,   D_p = sum_i w_ip r r^T
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Apic {
  static constexpr std::string_view name = "apic", label = "APIC";
  static constexpr std::string_view summary =
      "The particle carries a locally affine velocity: stable, keeps rotation and shear";

  double affine = 1;

  void describe(ParameterVisitor& v) {
    v.real(affine_spec("Share of the velocity gradient that a particle keeps. 1: all of it, 0: none (PIC)"), affine);
  }
  [[nodiscard]] Corner corner() const { return {.mode = AffineMode::full, .affine = affine}; }
};

} // namespace flipbook
