// SPDX-License-Identifier: MIT
// St. Venant and Kirchhoff's law in Hencky's logarithmic strain, eps = log sigma of F = U diag(sigma) V^T:
//   Psi = mu |eps|^2 + lambda/2 (tr eps)^2,   tau = U (2 mu eps + lambda tr eps) U^T
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct Hencky : hencky::Solid<Hencky> {
  static constexpr std::string_view name = "hencky", label = "Hencky";
  static constexpr std::string_view summary = "Stress proportional to the logarithm of the stretch";
  static constexpr bool inverts = false, flows = false;

  [[nodiscard]] static Memory<double> memory() { return {}; }
};

} // namespace flipbook
