// SPDX-License-Identifier: MIT
// Metal and clay: Hencky's energy, and von Mises' yield condition with linear hardening. With the deviator eps^ of the
// strains and the plastic strain p so far, remembered,
//   2 mu |eps^| <= sqrt(2/3) (yield_stress + hardening_modulus p)
// Beyond, eps^ is shortened by dgamma = (2 mu |eps^| - sqrt(2/3) (yield_stress + hardening_modulus p)) / (2 mu + 2/3
// hardening_modulus), and p grows by sqrt(2/3) dgamma (radial return). In 2D the deviator is that of the plane.
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct VonMises : hencky::Solid<VonMises> {
  static constexpr std::string_view name = "von_mises", label = "von Mises";
  static constexpr std::string_view summary = "Elastic up to its yield stress, then it flows and stays as it is";
  static constexpr bool inverts = false, flows = true, flow_only_takes = true;

  double yield_stress = 1e3;
  double hardening_modulus = 0;

  void describe(ParameterVisitor& v) {
    Elasticity::describe(v);
    v.real({.name = "yield_stress",
            .help = "Stress at which it begins to flow",
            .unit = "Pa",
            .min = 0,
            .max = 1e13,
            .level = Level::teach},
           yield_stress);
    v.real({.name = "hardening_modulus",
            .help = "Growth of the yield stress with the plastic strain",
            .unit = "Pa",
            .min = 0,
            .max = 1e13},
           hardening_modulus);
  }
  [[nodiscard]] static Memory<double> memory() { return {0, 0}; }

  template <std::size_t Dim, class T> auto back(std::array<T, Dim>& eps, Memory<T>& m) const {
    const double root = std::sqrt(2.0 / 3);
    const std::array<T, Dim> shear = hencky::deviator(eps);
    const T length = hencky::length(shear);
    const T yield = value<T>(root * yield_stress) + value<T>(root * hardening_modulus) * m[0];
    const T beyond = value<T>(2 * mu()) * length - yield;
    const auto where = beyond > T(0);
    const T gamma = choose(where, beyond * value<T>(1 / (2 * mu() + 2.0 / 3 * hardening_modulus)), T(0));
    const T share = gamma / larger(length, T(std::numeric_limits<NumberOf<T>>::min()));
    for (std::size_t d = 0; d < Dim; ++d) eps[d] -= share * shear[d];
    m[0] += value<T>(root) * gamma;
    return where;
  }
};

} // namespace flipbook
