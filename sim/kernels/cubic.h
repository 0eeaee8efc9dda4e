// SPDX-License-Identifier: MIT
// Cubic B-spline, one axis, in grid units. A particle at q touches four samples from base = floor(q) - 1 on; with
// f = q - base in [1, 2):
//   N(t) = 1/2 |t|^3 - t^2 + 2/3     |t| <= 1
//          1/6 (2 - |t|)^3           1 <= |t| <= 2
//   D = sum N t^2 = 1/3              with t = i - f
#pragma once

#include <array>
#include <string_view>

namespace flipbook {

struct Cubic {
  static constexpr std::string_view name = "cubic";
  static constexpr std::string_view summary = "Cubic B-spline: 4 samples per axis, continuous curvature";
  static constexpr int support = 4;

  template <class Real> using Weights = std::array<Real, support>;

  /// First sample touched; q >= 1.
  template <class Real> static constexpr int base(Real q) { return static_cast<int>(q) - 1; }
  /// N(i - f), in terms of the distance s = f - 1 behind the second sample.
  template <class Real> static constexpr Weights<Real> weights(Real f) {
    const Real s = f - 1, t = 1 - s;
    return {t * t * t / 6, (s / 2 - 1) * s * s + Real(2) / 3, (t / 2 - 1) * t * t + Real(2) / 3, s * s * s / 6};
  }
  /// Derivative of the weights by the particle's position.
  template <class Real> static constexpr Weights<Real> slopes(Real f) {
    const Real s = f - 1, t = 1 - s;
    return {-t * t / 2, (Real(1.5) * s - 2) * s, (2 - Real(1.5) * t) * t, s * s / 2};
  }
  /// D^-1 N (i - f).
  template <class Real> static constexpr Weights<Real> affine(Real f) {
    const Weights<Real> n = weights(f);
    return {-3 * f * n[0], 3 * (1 - f) * n[1], 3 * (2 - f) * n[2], 3 * (3 - f) * n[3]};
  }
  /// N (i - f).
  template <class Real> static constexpr Weights<Real> moment(Real f) {
    const Weights<Real> n = weights(f);
    return {-f * n[0], (1 - f) * n[1], (2 - f) * n[2], (3 - f) * n[3]};
  }
  /// D = sum N (i - f)^2.
  template <class Real> static constexpr Real second_moment(Real) { return Real(1) / 3; }
};

} // namespace flipbook
