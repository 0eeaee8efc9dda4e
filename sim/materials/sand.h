// SPDX-License-Identifier: MIT
// Dry sand: Drucker and Prager's yield condition with Hencky's energy [Klar, Gast, Pradhana, Fu, Schroeder, Jiang,
// Teran 2016]. With the strains eps, their deviator eps^ and trace, sand neither stands tension nor more shear than
//   |eps^| <= - (d lambda + 2 mu) / (2 mu) tr(eps) alpha,   alpha = sqrt(2/3) 2 sin phi / (3 - sin phi)
// Beyond, eps^ is shortened to this length; where tr(eps) >= 0 all strain is lost. The angle of friction grows with
// what has been sheared,
//   phi = h0 + (h1 q - h3) e^(-h2 q),   q: the sum of the strains that were lost
// and the volume that was gained in tension is taken back in compression before there is pressure [Tampubolon et al.
// 2017]. Remembered: q, and the logarithm of that volume.
#pragma once

#include "sim/materials/elasticity.h"

namespace flipbook {

struct Sand : hencky::Solid<Sand> {
  static constexpr std::string_view name = "sand", label = "sand";
  static constexpr std::string_view summary =
      "Dry grains: friction holds what is pressed, nothing holds what is pulled";
  static constexpr bool inverts = false, flows = true, flow_only_takes = true;

  double friction_angle = 35, h1 = 0, h2 = 0.2, h3 = 0;

  Sand() {
    E = 3.537e5;
    nu = 0.3;
    density = 2200;
  }
  void describe(ParameterVisitor& v) {
    Elasticity::describe(v);
    v.real({.name = "friction_angle",
            .help = "Angle of internal friction, h0: how steep a heap is",
            .unit = "degrees",
            .min = 0,
            .max = 80,
            .level = Level::teach},
           friction_angle);
    v.real({.name = "h1",
            .help = "Growth of the friction angle where sand is sheared",
            .unit = "degrees",
            .min = 0,
            .max = 90},
           h1);
    v.real({.name = "h2", .help = "How soon that growth fades", .min = 0, .max = 100}, h2);
    v.real(
        {.name = "h3", .help = "What fresh sand lacks of the friction angle", .unit = "degrees", .min = 0, .max = 80},
        h3);
  }
  [[nodiscard]] static Memory<double> memory() { return {0, 0}; }

  template <std::size_t Dim, class T> auto back(std::array<T, Dim>& eps, Memory<T>& m) const {
    constexpr auto mean = NumberOf<T>(1) / NumberOf<T>(Dim);
    const std::array<T, Dim> before = eps;
    for (T& each : eps) each += m[1] * T(mean); // the volume that was gained
    const T volume = hencky::sum(eps);
    const std::array<T, Dim> shear = hencky::deviator(eps);
    const T length = hencky::length(shear);
    constexpr double dimension = Dim;
    const T most = -value<T>((dimension * lambda() + 2 * mu()) / (2 * mu())) * volume * alpha(m[0]);
    const auto apart = volume >= T(0), sheared = length > most;
    const T kept = most / larger(length, T(std::numeric_limits<NumberOf<T>>::min()));
    T lost(0);
    for (std::size_t d = 0; d < Dim; ++d) {
      eps[d] = choose(apart, T(0), choose(sheared, kept * shear[d] + volume * T(mean), eps[d]));
      lost = multiply_add(eps[d] - before[d], eps[d] - before[d], lost);
    }
    const auto where = apart || sheared || m[1] > T(0);
    m[0] += choose(apart || sheared, detail::root(lost), T(0));
    m[1] = choose(apart, volume, T(0));
    return where;
  }

  /// The yield condition's alpha after so much shear.
  template <class T> [[nodiscard]] T alpha(const T& q) const {
    using std::sin;
    constexpr double degree = 0.017453292519943295;
    const T phi = value<T>(degree) *
                  (value<T>(friction_angle) + (value<T>(h1) * q - value<T>(h3)) * exponential(-value<T>(h2) * q));
    const T sine = sin(phi);
    return value<T>(2 * std::sqrt(2.0 / 3)) * sine / (T(3) - sine);
  }
};

} // namespace flipbook
