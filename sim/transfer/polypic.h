// SPDX-License-Identifier: MIT
// Polynomial particle-in-cell [Fu et al. 2017] with the multilinear modes: besides C the particle carries the products
// r_x r_y, .. of the axes.
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + sum_s c_ps r^s),   r^s = prod_{d in s} (x_i - x_p)_d
//   G2P  v_p <- sum_i w_ip u_i,   c_ps <- affine sum_i w_ip (D_p^-1 r)^s u_i
// over the non-empty sets s of axes. With the linear kernel the modes span everything that a particle's samples can
// hold, so that one particle there and back loses nothing.
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Polypic {
  static constexpr std::string_view name = "polypic", label = "PolyPIC";
  static constexpr std::string_view summary =
      "The particle carries a multilinear velocity: with the linear kernel all that its samples can hold";

  double affine = 1;

  void describe(ParameterVisitor& v) {
    v.real(affine_spec("Share of the polynomial modes that a particle keeps. 1: all of them, 0: none (PIC)"), affine);
  }
  [[nodiscard]] Corner corner() const { return {.mode = AffineMode::polynomial, .affine = affine}; }
};

} // namespace flipbook
