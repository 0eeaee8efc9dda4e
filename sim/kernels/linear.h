// SPDX-License-Identifier: MIT
// Linear B-spline, one axis, in grid units. A particle at q touches the samples base = floor(q) and base + 1; with
// f = q - base in [0, 1):
//   N(t) = 1 - |t|,   D = sum N t^2 = f (1 - f)   with t = i - f
// D vanishes on a sample, but D^-1 N t is the slope dN/df everywhere, so the affine weights need no division.
#pragma once

#include "sim/core/value.h"

#include <array>
#include <string_view>

namespace flipbook {

struct Linear {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary = "Linear B-spline: 2 samples per axis, sharp and fast";
  static constexpr int support = 2;

  template <class T> using Weights = std::array<T, support>;

  /// First sample touched; q >= 0.
  template <class T> static T base(T q) { return whole(q); }
  /// N(i - f).
  template <class T> static constexpr Weights<T> weights(T f) { return {T(1) - f, f}; }
  /// Derivative of the weights by the particle's position.
  template <class T> static constexpr Weights<T> slopes(T) { return {T(-1), T(1)}; }
  /// D^-1 N (i - f).
  template <class T> static constexpr Weights<T> affine(T f) { return slopes(f); }
  /// N (i - f).
  template <class T> static constexpr Weights<T> moment(T f) {
    const T d = second_moment(f);
    return {-d, d};
  }
  /// D = sum N (i - f)^2.
  template <class T> static constexpr T second_moment(T f) { return f * (T(1) - f); }
};

} // namespace flipbook
