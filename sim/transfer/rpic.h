// SPDX-License-Identifier: MIT
// Rigid particle-in-cell [Jiang et al. 2015]: the particle carries its velocity and its spin.
//   P2G  (m u)_i = sum_p w_ip m_p (v_p + omega_p x r),   r = x_i - x_p
//   G2P  v_p <- sum_i w_ip u_i,   omega_p <- affine K_p^-1 L_p
//        L_p = sum_i w_ip r x u_i,   K_p = sum_i w_ip (|r|^2 I - r r^T)   (the mass cancels)
// The other form keeps the antisymmetric part of APIC's C instead. Both agree for quadratic and cubic kernels, where
// D_p is a multiple of the identity; with the linear kernel only K_p^-1 L_p conserves angular momentum.
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Rpic {
  static constexpr std::string_view name = "rpic", label = "RPIC";
  static constexpr std::string_view summary = "The particle carries its spin: keeps rotation, damps shear";

  enum class Form { inertia, skew };
  static constexpr Option forms[] = {{"inertia", "omega = K^-1 L, from the inertia of the particle's samples"},
                                     {"skew", "the antisymmetric part of APIC's C"}};

  double affine = 1;
  Form form = Form::inertia;

  void describe(ParameterVisitor& v) {
    v.real(affine_spec("Share of the spin that a particle keeps. 1: all of it, 0: none (PIC)"), affine);
    v.choice({.name = "form", .help = "How RPIC finds the spin of a particle"}, form, forms);
  }
  [[nodiscard]] Corner corner() const {
    const bool skew = form == Form::skew;
    return {.mode = skew ? AffineMode::full : AffineMode::rigid, .affine = affine, .skew = skew};
  }
};

} // namespace flipbook
