// SPDX-License-Identifier: MIT
// Compressible neo-Hookean rubber:
//   Psi = mu/2 (tr F^T F - d) - mu ln J + lambda/2 ln^2 J,   tau = mu (F F^T - I) + lambda ln J I
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct NeoHookean : Elasticity {
  static constexpr std::string_view name = "neo_hookean", label = "neo-Hookean";
  static constexpr std::string_view summary = "Rubber and jelly; cannot be turned inside out";
  static constexpr bool inverts = false, flows = false;

  [[nodiscard]] static Memory<double> memory() { return {}; }
  template <int Dim, class T> [[nodiscard]] T energy(const Square<Dim, T>& F, const Memory<T>&) const {
    return energy(State<Dim, T>(F));
  }
  template <int Dim, class T> [[nodiscard]] Square<Dim, T> kirchhoff(const Square<Dim, T>& F, const Memory<T>&) const {
    return kirchhoff(State<Dim, T>(F));
  }
  template <int Dim, class T> [[nodiscard]] T wave_modulus(const Square<Dim, T>& F, const Memory<T>&) const {
    return wave_modulus(State<Dim, T>(F));
  }
  template <int Dim, class T> void flow(Square<Dim, T>&, Memory<T>&) const {}
  template <int Dim, class T> [[nodiscard]] Response<Dim, T> respond(const Square<Dim, T>& F, const Memory<T>&) const {
    const State<Dim, T> s(F);
    const T psi = energy(s);
    return {psi, psi, kirchhoff(s), wave_modulus(s)};
  }

private:
  /// What all formulas consist of. The two terms with mu differ by squares of small strains, which the rounding of
  /// |F|^2 and ln J would drown; J^2 - 1 = det F F^T - 1 as a polynomial of F F^T - I keeps them.
  template <int Dim, class T> struct State {
    Square<Dim, T> strain; ///< F F^T - I
    T ln_J, distortion;    ///< |F|^2 - d - 2 ln J

    explicit State(const Square<Dim, T>& F) : strain(squared(F) - identity<Dim, T>()) {
      T higher = determinant(strain); // J^2 - 1 less tr(F F^T - I)
      if constexpr (Dim == 3)
        for (std::size_t a = 0; a < 3; ++a) {
          const std::size_t b = (a + 1) % 3;
          higher += strain[a][a] * strain[b][b] - strain[a][b] * strain[a][b];
        }
      const T grown = trace(strain) + higher, near = logarithm_of_next(grown);
      const auto small = detail::magnitude(grown) < T(0.5) && trace(strain) < T(0.5);
      ln_J = choose(small, T(0.5) * near, logarithm(determinant(F)));
      distortion = choose(small, (grown - near) - higher, trace(strain) - T(2) * ln_J);
    }
  };
  template <int Dim, class T> [[nodiscard]] T energy(const State<Dim, T>& s) const {
    return value<T>(mu() / 2) * s.distortion + value<T>(lambda() / 2) * s.ln_J * s.ln_J;
  }
  template <int Dim, class T> [[nodiscard]] Square<Dim, T> kirchhoff(const State<Dim, T>& s) const {
    Square<Dim, T> tau = value<T>(mu()) * s.strain;
    for (std::size_t a = 0; a < Dim; ++a) tau[a][a] += value<T>(lambda()) * s.ln_J;
    return tau;
  }
  /// Along an axis with the stretch s: rho_0 c^2 = mu (1 + s^2) + lambda (1 - ln J).
  template <int Dim, class T> [[nodiscard]] T wave_modulus(const State<Dim, T>& s) const {
    return value<T>(mu()) * (T(1) + squared_stretch_of(s.strain)) + value<T>(lambda()) * (T(1) + larger(-s.ln_J, T(0)));
  }
};

} // namespace flipbook
