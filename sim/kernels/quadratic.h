// SPDX-License-Identifier: MIT
// Quadratic B-spline, one axis, in grid units. A particle at q touches three samples from base = floor(q - 1/2) on;
// with f = q - base in [1/2, 3/2):
//   N(t) = 3/4 - t^2             |t| <= 1/2
//          1/2 (3/2 - |t|)^2     1/2 <= |t| <= 3/2
//   D = sum N t^2 = 1/4          with t = i - f
#pragma once

#include "sim/core/value.h"

#include <array>
#include <string_view>

namespace flipbook {

struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr std::string_view summary = "Quadratic B-spline: 3 samples per axis, continuous gradients";
  static constexpr int support = 3;

  template <class T> using Weights = std::array<T, support>;

  /// First sample touched; q >= 1/2.
  template <class T> static T base(T q) { return whole(q - T(0.5)); }
  /// N(i - f).
  template <class T> static constexpr Weights<T> weights(T f) {
    const T a = T(1.5) - f, b = f - T(1), c = f - T(0.5);
    return {T(0.5) * a * a, T(0.75) - b * b, T(0.5) * c * c};
  }
  /// Derivative of the weights by the particle's position.
  template <class T> static constexpr Weights<T> slopes(T f) { return {f - T(1.5), T(2) - T(2) * f, f - T(0.5)}; }
  /// D^-1 N (i - f).
  template <class T> static constexpr Weights<T> affine(T f) {
    const Weights<T> n = weights(f);
    return {T(-4) * f * n[0], T(4) * (T(1) - f) * n[1], T(4) * (T(2) - f) * n[2]};
  }
  /// N (i - f).
  template <class T> static constexpr Weights<T> moment(T f) {
    const Weights<T> n = weights(f);
    return {-f * n[0], (T(1) - f) * n[1], (T(2) - f) * n[2]};
  }
  /// D = sum N (i - f)^2.
  template <class T> static constexpr T second_moment(T) { return T(0.25); }
};

} // namespace flipbook
