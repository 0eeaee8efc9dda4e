// SPDX-License-Identifier: MIT
// Snow [Stomakhin, Schroeder, Chai, Teran, Selle 2013]: fixed corotated elasticity of the elastic part F, whose
// singular values stay within [1 - theta_c, 1 + theta_s]; what is beyond flows, and compacted snow is harder:
//   mu, lambda <- mu, lambda times e^(xi (1 - J_P)),   J_P = det F_P, remembered
// The factor is bounded, so that the speed of waves is: within a step of that length nothing else is known of them.
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct Snow : Elasticity {
  static constexpr std::string_view name = "snow", label = "snow";
  static constexpr std::string_view summary = "Packs and hardens where it is pressed, crumbles where it is pulled";
  static constexpr bool inverts = true, flows = true, flow_only_takes = false;

  double critical_compression = 2.5e-2;
  double critical_stretch = 7.5e-3;
  double hardening = 10;
  double hardest = 20;

  Snow() {
    E = 1.4e5;
    nu = 0.2;
    density = 400;
  }
  void describe(ParameterVisitor& v) {
    Elasticity::describe(v);
    v.real({.name = "critical_compression",
            .help = "Compression beyond which snow packs",
            .min = 0,
            .max = 0.9,
            .level = Level::teach},
           critical_compression);
    v.real({.name = "critical_stretch",
            .help = "Stretch beyond which snow crumbles",
            .min = 0,
            .max = 10,
            .level = Level::teach},
           critical_stretch);
    v.real({.name = "hardening",
            .help = "How much harder packed snow is: the exponent per lost volume",
            .min = 0,
            .max = 100,
            .level = Level::teach},
           hardening);
    v.real({.name = "hardest", .help = "Most that packed snow is harder than fresh snow", .min = 1, .max = 1e6},
           hardest);
  }
  [[nodiscard]] static Memory<double> memory() { return {1, 0}; }
  /// By how much it has been compacted: 1 - J_P.
  [[nodiscard]] static double plastic(const Memory<double>& m) { return 1 - m[0]; }

  template <int Dim, class T> [[nodiscard]] T energy(const Square<Dim, T>& F, const Memory<T>& m) const {
    return corotated::energy(F, polar(F).R, hardened(m));
  }
  template <int Dim, class T>
  [[nodiscard]] Square<Dim, T> kirchhoff(const Square<Dim, T>& F, const Memory<T>& m) const {
    return corotated::kirchhoff(F, polar(F).R, hardened(m));
  }
  template <int Dim, class T> [[nodiscard]] T wave_modulus(const Square<Dim, T>& F, const Memory<T>& m) const {
    return corotated::wave_modulus(F, hardened(m));
  }
  template <int Dim, class T> void flow(Square<Dim, T>& F, Memory<T>& m) const { flow(F, svd(F), m); }
  template <int Dim, class T> [[nodiscard]] Response<Dim, T> respond(Square<Dim, T>& F, Memory<T>& m) const {
    const Svd<Dim, T> s = svd(F);
    const Square<Dim, T> R = times_transposed(s.U, s.V); // of F before flow and after
    const T before = corotated::energy(F, R, hardened(m));
    flow(F, s, m);
    const Moduli<T> now = hardened(m);
    return {before, corotated::energy(F, R, now), corotated::kirchhoff(F, R, now), corotated::wave_modulus(F, now)};
  }

private:
  /// Limits of J_P, beyond which neither stiffness nor looks change: what was turned inside out has no volume left to
  /// pack, and what has come apart only grows.
  static constexpr double least_volume = 1e-3, most_volume = 1e3;
  /// As little as crumbled snow keeps of its stiffness: more than what single precision takes for nothing.
  static constexpr double softest = 1e-6;

  template <class T> [[nodiscard]] Moduli<T> hardened(const Memory<T>& m) const {
    const T exponent = smaller(value<T>(hardening) * (T(1) - m[0]), value<T>(std::log(hardest)));
    const T harder = exponential(larger(exponent, value<T>(std::log(softest))));
    return {harder * value<T>(mu()), harder * value<T>(lambda())};
  }
  template <int Dim, class T> void flow(Square<Dim, T>& F, const Svd<Dim, T>& s, Memory<T>& m) const {
    const T least = value<T>(1 - critical_compression), most = value<T>(1 + critical_stretch);
    const auto beyond = s.sigma[Dim - 1] < least || s.sigma[0] > most; // sorted
    if (!any_of(beyond)) return;
    std::array<T, Dim> sigma;
    T before(1), after(1);
    for (std::size_t d = 0; d < Dim; ++d) {
      sigma[d] = larger(smaller(s.sigma[d], most), least);
      before *= s.sigma[d];
      after *= sigma[d];
    }
    const T volume = smaller(larger(m[0] * before / after, value<T>(least_volume)), value<T>(most_volume));
    m[0] = choose(beyond, volume, m[0]);
    const Square<Dim, T> flown = times_transposed(s.U * diagonal<Dim, T>(sigma), s.V);
    F = square<Dim, T>([&](std::size_t a, std::size_t b) { return choose(beyond, flown[a][b], F[a][b]); });
  }
};

} // namespace flipbook
