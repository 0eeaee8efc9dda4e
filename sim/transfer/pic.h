// SPDX-License-Identifier: MIT
// Particle-in-cell: the grid's velocity replaces the particle's.
//   P2G  (m u)_i = sum_p w_ip m_p v_p
//   G2P  v_p <- sum_i w_ip u_i
#pragma once

#include "sim/frame/parameters.h"
#include "sim/transfer/corner.h"

namespace flipbook {

struct Pic {
  static constexpr std::string_view name = "pic", label = "PIC";
  static constexpr std::string_view summary = "The grid's velocity replaces the particle's: stable and very viscous";

  void describe(ParameterVisitor&) {}
  [[nodiscard]] Corner corner() const { return {}; }
};

} // namespace flipbook
