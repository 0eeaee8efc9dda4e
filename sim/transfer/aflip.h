// SPDX-License-Identifier: MIT
// Affine FLIP: APIC's affine velocity together with FLIP's velocity update.
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + C_p (x_i - x_p))
//   G2P  v_p <- sum_i w_ip u_i + flip_ratio (v_p - sum_i w_ip u_old_i),   C_p <- affine (APIC's C_p)
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Aflip {
  static constexpr std::string_view name = "aflip", label = "AFLIP";
  static constexpr std::string_view summary =
      "APIC's affine velocity with FLIP's update: lively, with less noise than FLIP";
  static constexpr bool parameter_in_title = true;

  double flip_ratio = 1;
  double affine = 1;

  void describe(ParameterVisitor& v) {
    v.real(flip_ratio_spec, flip_ratio);
    v.real(affine_spec("Share of the velocity gradient that a particle keeps. 1: all of it, 0: none"), affine);
  }
  [[nodiscard]] Corner corner() const { return {.mode = AffineMode::full, .flip_ratio = flip_ratio, .affine = affine}; }
};

} // namespace flipbook
