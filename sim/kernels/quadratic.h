// SPDX-License-Identifier: MIT
// Quadratic B-spline, one axis, in grid units. A particle at q touches three samples from base = floor(q - 1/2) on;
// with f = q - base in [1/2, 3/2):
//   N(t) = 3/4 - t^2             |t| <= 1/2
//          1/2 (3/2 - |t|)^2     1/2 <= |t| <= 3/2
//   D = sum N t^2 = 1/4          with t = i - f
#pragma once

#include <array>
#include <string_view>

namespace flipbook {

struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr std::string_view summary = "Quadratic B-spline: 3 samples per axis, continuous gradients";
  static constexpr int support = 3;

  template <class Real> using Weights = std::array<Real, support>;

  /// First sample touched; q >= 1/2.
  template <class Real> static constexpr int base(Real q) { return static_cast<int>(q - Real(0.5)); }
  /// N(i - f).
  template <class Real> static constexpr Weights<Real> weights(Real f) {
    const Real a = Real(1.5) - f, b = f - 1, c = f - Real(0.5);
    return {Real(0.5) * a * a, Real(0.75) - b * b, Real(0.5) * c * c};
  }
  /// Derivative of the weights by the particle's position.
  template <class Real> static constexpr Weights<Real> slopes(Real f) {
    return {f - Real(1.5), -2 * (f - 1), f - Real(0.5)};
  }
  /// D^-1 N (i - f).
  template <class Real> static constexpr Weights<Real> affine(Real f) {
    const Weights<Real> n = weights(f);
    return {-4 * f * n[0], 4 * (1 - f) * n[1], 4 * (2 - f) * n[2]};
  }
  /// N (i - f).
  template <class Real> static constexpr Weights<Real> moment(Real f) {
    const Weights<Real> n = weights(f);
    return {-f * n[0], (1 - f) * n[1], (2 - f) * n[2]};
  }
  /// D = sum N (i - f)^2.
  template <class Real> static constexpr Real second_moment(Real) { return Real(0.25); }
};

} // namespace flipbook
