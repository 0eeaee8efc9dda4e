// SPDX-License-Identifier: MIT
// A liquid that is slightly compressible, by Tait's equation:
//   p = K/gamma (J^-gamma - 1),   tau = -p J I,   Psi = K/gamma (J^(1 - gamma) / (gamma - 1) + J - gamma / (gamma - 1))
// It resists no shear, so F becomes J^(1/d) I, and no tension: where it would be stretched (J > 1) it cavitates and
// begins anew at J = 1.
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct WeaklyCompressible {
  static constexpr std::string_view name = "weakly_compressible", label = "weakly compressible";
  static constexpr std::string_view summary = "A liquid by Tait's equation: no shear, no tension";
  static constexpr bool inverts = false, flows = true, flow_only_takes = true;

  double bulk_modulus = 1e5;
  double gamma = 7;
  double density = 1000;

  void describe(ParameterVisitor& v) {
    v.real({.name = "bulk_modulus",
            .help = "How hard the liquid is to compress",
            .unit = "Pa",
            .min = 1e-3,
            .max = 1e13,
            .level = Level::teach},
           bulk_modulus);
    v.real({.name = "gamma", .help = "Exponent of Tait's equation", .min = 1.1, .max = 20}, gamma);
    Elasticity::describe_density(v, density);
  }
  [[nodiscard]] static Memory<double> memory() { return {}; }
  template <int Dim, class T> [[nodiscard]] T energy(const Square<Dim, T>& F, const Memory<T>&) const {
    return energy(State<T>(determinant(F), gamma));
  }
  template <int Dim, class T> [[nodiscard]] Square<Dim, T> kirchhoff(const Square<Dim, T>& F, const Memory<T>&) const {
    return kirchhoff<Dim>(State<T>(determinant(F), gamma));
  }
  template <int Dim, class T> [[nodiscard]] T wave_modulus(const Square<Dim, T>& F, const Memory<T>&) const {
    return wave_modulus(State<T>(determinant(F), gamma));
  }
  template <int Dim, class T> void flow(Square<Dim, T>& F, Memory<T>&) const {
    flow(F, State<T>(determinant(F), gamma));
  }
  template <int Dim, class T> [[nodiscard]] Response<Dim, T> respond(Square<Dim, T>& F, const Memory<T>&) const {
    State<T> s(determinant(F), gamma);
    const T before = energy(s);
    flow(F, s);
    s = {smaller(s.grown, T(0)), smaller(s.ln_J, T(0)), larger(s.squeezed, T(0))};
    return {before, energy(s), kirchhoff<Dim>(s), wave_modulus(s)};
  }

private:
  /// What all formulas consist of, each without the 1 that would drown small compressions in its rounding.
  template <class T> struct State {
    T grown, ln_J, squeezed; ///< J - 1, ln J, J^(1 - gamma) - 1

    State(const T& J, double gamma)
        : grown(J - T(1)), ln_J(logarithm_of_next(grown)), squeezed(exponential_less(value<T>(1 - gamma) * ln_J)) {}
    State(const T& g, const T& l, const T& s) : grown(g), ln_J(l), squeezed(s) {}
  };
  template <class T> [[nodiscard]] T energy(const State<T>& s) const {
    return value<T>(bulk_modulus / gamma) * (value<T>(1 / (gamma - 1)) * s.squeezed + s.grown);
  }
  template <int Dim, class T> [[nodiscard]] Square<Dim, T> kirchhoff(const State<T>& s) const {
    std::array<T, Dim> tau;
    tau.fill(value<T>(bulk_modulus / gamma) * (s.grown - s.squeezed));
    return diagonal<Dim, T>(tau);
  }
  /// J^2 d2Psi/dJ2 = K J^(1 - gamma)
  template <class T> [[nodiscard]] T wave_modulus(const State<T>& s) const {
    return value<T>(bulk_modulus) * (T(1) + larger(s.squeezed, T(0)));
  }
  template <int Dim, class T> void flow(Square<Dim, T>& F, const State<T>& s) const {
    std::array<T, Dim> side;
    side.fill(exponential(smaller(s.ln_J, T(0)) * T(NumberOf<T>(1) / NumberOf<T>(Dim))));
    F = diagonal<Dim, T>(side);
  }
};

} // namespace flipbook
