// SPDX-License-Identifier: MIT
// Fixed corotated elasticity [Stomakhin et al. 2012], with the rotation R of F = R S:
//   Psi = mu |F - R|^2 + lambda/2 (J - 1)^2,   tau = 2 mu (F - R) F^T + lambda (J - 1) J I
// Finite for every F: what was turned inside out comes back.
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct FixedCorotated : Elasticity {
  static constexpr std::string_view name = "fixed_corotated", label = "fixed corotated";
  static constexpr std::string_view summary = "Elastic like rubber for small strains; survives being turned inside out";
  static constexpr bool inverts = true, flows = false;

  [[nodiscard]] static Memory<double> memory() { return {}; }
  template <int Dim, class T> [[nodiscard]] T energy(const Square<Dim, T>& F, const Memory<T>&) const {
    return corotated::energy(F, polar(F).R, moduli<T>());
  }
  template <int Dim, class T> [[nodiscard]] Square<Dim, T> kirchhoff(const Square<Dim, T>& F, const Memory<T>&) const {
    return corotated::kirchhoff(F, polar(F).R, moduli<T>());
  }
  template <int Dim, class T> [[nodiscard]] T wave_modulus(const Square<Dim, T>& F, const Memory<T>&) const {
    return corotated::wave_modulus(F, moduli<T>());
  }
  template <int Dim, class T> void flow(Square<Dim, T>&, Memory<T>&) const {}
  template <int Dim, class T> [[nodiscard]] Response<Dim, T> respond(const Square<Dim, T>& F, const Memory<T>&) const {
    const Moduli<T> m = moduli<T>();
    const Square<Dim, T> R = polar(F).R;
    const T psi = corotated::energy(F, R, m);
    return {psi, psi, corotated::kirchhoff(F, R, m), corotated::wave_modulus(F, m)};
  }
};

} // namespace flipbook
