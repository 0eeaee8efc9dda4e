// SPDX-License-Identifier: MIT
// Cubic B-spline, one axis, in grid units. A particle at q touches four samples from base = floor(q) - 1 on; with
// f = q - base in [1, 2):
//   N(t) = 1/2 |t|^3 - t^2 + 2/3     |t| <= 1
//          1/6 (2 - |t|)^3           1 <= |t| <= 2
//   D = sum N t^2 = 1/3              with t = i - f
#pragma once

#include "sim/core/value.h"

#include <array>
#include <string_view>

namespace flipbook {

struct Cubic {
  static constexpr std::string_view name = "cubic";
  static constexpr std::string_view summary = "Cubic B-spline: 4 samples per axis, continuous curvature";
  static constexpr int support = 4;

  template <class T> using Weights = std::array<T, support>;

  /// First sample touched; q >= 1.
  template <class T> static T base(T q) { return whole(q) - T(1); }
  /// N(i - f), in terms of the distance s = f - 1 behind the second sample.
  template <class T> static constexpr Weights<T> weights(T f) {
    constexpr NumberOf<T> sixth = NumberOf<T>(1) / 6, middle = NumberOf<T>(2) / 3;
    const T s = f - T(1), t = T(1) - s;
    return {t * t * t * T(sixth), (T(0.5) * s - T(1)) * s * s + T(middle), (T(0.5) * t - T(1)) * t * t + T(middle),
            s * s * s * T(sixth)};
  }
  /// Derivative of the weights by the particle's position.
  template <class T> static constexpr Weights<T> slopes(T f) {
    const T s = f - T(1), t = T(1) - s;
    return {T(-0.5) * t * t, (T(1.5) * s - T(2)) * s, (T(2) - T(1.5) * t) * t, T(0.5) * s * s};
  }
  /// D^-1 N (i - f).
  template <class T> static constexpr Weights<T> affine(T f) {
    const Weights<T> n = weights(f);
    return {T(-3) * f * n[0], T(3) * (T(1) - f) * n[1], T(3) * (T(2) - f) * n[2], T(3) * (T(3) - f) * n[3]};
  }
  /// N (i - f).
  template <class T> static constexpr Weights<T> moment(T f) {
    const Weights<T> n = weights(f);
    return {-f * n[0], (T(1) - f) * n[1], (T(2) - f) * n[2], (T(3) - f) * n[3]};
  }
  /// D = sum N (i - f)^2.
  template <class T> static constexpr T second_moment(T) { return T(NumberOf<T>(1) / 3); }
};

} // namespace flipbook
