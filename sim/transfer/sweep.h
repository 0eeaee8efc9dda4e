// SPDX-License-Identifier: MIT
// What the sweeps over particles share: the choice of the instance, made once per sweep, and plain pointers to columns.
#pragma once

#include "sim/core/field.h"
#include "sim/transfer/corner.h"
#include "sim/transfer/modes.h"

#include <array>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace flipbook {

/// body(Mode{}, Kernel{}): the loop for what the particles remember, in packs, and the kernel in use.
template <int Dim, class Real, class Body>
void with_sweep(const Corner& corner, KernelName kernel, const Particles<Dim, Real>& particles, Body&& body) {
  if (particles.mode != corner.mode) throw std::logic_error("the particles do not remember what this scheme needs");
  with_mode<Dim, Pack<Real>>(corner.mode, [&](auto mode) { with_kernel(kernel, [&](auto k) { body(mode, k); }); });
}

/// Pointers to the first entry of each column; const where the particles are.
template <std::size_t N, class Columns> [[nodiscard]] auto pointers(Columns& columns) {
  std::array<decltype(columns[0].data()), N> p{};
  for (std::size_t i = 0; i < N; ++i) p[i] = columns[i].data();
  return p;
}

} // namespace flipbook
