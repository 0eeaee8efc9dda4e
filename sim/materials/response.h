// SPDX-License-Identifier: MIT
// All that is asked of a material in a step, at once: a material whose answers need the same decomposition of F gives
// them together, by a member respond(F, memory); of the others they are put together here.
#pragma once

#include "sim/materials/material.h"

namespace flipbook {

template <int Dim, class T> struct Response {
  T before_flow, energy; ///< energy of a unit of undeformed volume, before plastic flow and after
  Square<Dim, T> tau;    ///< Kirchhoff stress, after it
  T wave_modulus;        ///< after it
};

/// Lets F and memory flow.
template <class M, int Dim, class T>
[[nodiscard]] inline Response<Dim, T> response_of(const M& material, Square<Dim, T>& F, Memory<T>& memory) {
  if constexpr (requires { material.respond(F, memory); }) {
    return material.respond(F, memory);
  } else {
    const T before = material.energy(F, memory);
    T after = before;
    if constexpr (M::flows) {
      material.flow(F, memory);
      after = material.energy(F, memory);
    }
    return {before, after, material.kirchhoff(F, memory), material.wave_modulus(F, memory)};
  }
}

} // namespace flipbook
