// SPDX-License-Identifier: MIT
// Linear B-spline, one axis, in grid units. A particle at q touches the samples base = floor(q) and base + 1; with
// f = q - base in [0, 1):
//   N(t) = 1 - |t|,   D = sum N t^2 = f (1 - f)   with t = i - f
// D vanishes on a sample, but D^-1 N t is the slope dN/df everywhere, so the affine weights need no division.
#pragma once

#include <array>
#include <string_view>

namespace flipbook {

struct Linear {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary = "Linear B-spline: 2 samples per axis, sharp and fast";
  static constexpr int support = 2;

  template <class Real> using Weights = std::array<Real, support>;

  /// First sample touched; q >= 0.
  template <class Real> static constexpr int base(Real q) { return static_cast<int>(q); }
  /// N(i - f).
  template <class Real> static constexpr Weights<Real> weights(Real f) { return {1 - f, f}; }
  /// Derivative of the weights by the particle's position.
  template <class Real> static constexpr Weights<Real> slopes(Real) { return {Real(-1), Real(1)}; }
  /// D^-1 N (i - f).
  template <class Real> static constexpr Weights<Real> affine(Real f) { return slopes(f); }
  /// N (i - f).
  template <class Real> static constexpr Weights<Real> moment(Real f) {
    const Real d = second_moment(f);
    return {-d, d};
  }
  /// D = sum N (i - f)^2.
  template <class Real> static constexpr Real second_moment(Real f) { return f * (1 - f); }
};

} // namespace flipbook
