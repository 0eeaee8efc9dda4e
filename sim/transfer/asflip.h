// SPDX-License-Identifier: MIT
// Affine separable FLIP [Fei, Guo, Wu, Huang, Gao 2021]: AFLIP whose particles also move apart from the grid where the
// material separates, so that what the grid has glued together can come apart.
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + C_p (x_i - x_p))
//   G2P  v_p <- sum_i w_ip u_i + flip_ratio (v_p - sum_i w_ip u_old_i),   C_p <- affine (APIC's C_p)
//        x_p <- x_p + dt (sum_i w_ip u_i + beta (v_p - sum_i w_ip u_i))
// with beta = beta_max where ln det F + dt tr(grad u) >= -0.001, else beta_min. With beta_min = beta_max = 1 and
// affine = 0 particles move with their own velocity, which is called NFLIP. A liquid does not come apart within itself,
// and has no F: there it is AFLIP.
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Asflip {
  static constexpr std::string_view name = "asflip", label = "ASFLIP";
  static constexpr std::string_view summary =
      "AFLIP whose particles also move apart where the material of a solid separates; AFLIP in a liquid";
  static constexpr bool parameter_in_title = true;

  double flip_ratio = 0.97;
  double affine = 1;
  double beta_min = 0, beta_max = 1;

  void describe(ParameterVisitor& v) {
    v.real(flip_ratio_spec, flip_ratio);
    v.real(affine_spec("Share of the velocity gradient that a particle keeps. 1: all of it, 0: none"), affine);
    v.real(
        {.name = "beta_min",
         .help = "Share of what v_p holds beyond the grid that a particle moves with where the material is compressed",
         .min = 0,
         .max = 1},
        beta_min);
    v.real({.name = "beta_max",
            .help = "Share of what v_p holds beyond the grid that a particle moves with where the material separates",
            .min = 0,
            .max = 1,
            .level = Level::teach,
            .at_min = "AFLIP",
            .at_max = "ASFLIP"},
           beta_max);
  }
  [[nodiscard]] Corner corner() const {
    return {.mode = AffineMode::full,
            .flip_ratio = flip_ratio,
            .affine = affine,
            .beta_min = beta_min,
            .beta_max = beta_max};
  }
};

} // namespace flipbook
