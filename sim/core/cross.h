// SPDX-License-Identifier: MIT
// Cross products of axis vectors, the same in two and three dimensions: e_a x e_b = sign e_c. In 2D the only spin axis
// is the one out of the plane, number 0.
#pragma once

#include "sim/core/vec.h"

namespace flipbook {

/// The c in e_a x e_b = sign e_c; a and b differ.
template <int Dim> [[nodiscard]] constexpr int cross_axis(int a, int b) {
  return Dim == 2 ? 0 : 3 - a - b;
}

/// The sign in e_a x e_b = sign e_c; a and b differ.
template <int Dim> [[nodiscard]] constexpr int cross_sign(int a, int b) {
  return (Dim == 2 ? b > a : b == (a + 1) % 3) ? 1 : -1;
}

/// x x y: a number in 2D, a vector in 3D.
template <int Dim, class Real>
[[nodiscard]] Vec<spin<Dim>, Real> cross(const Vec<Dim, Real>& x, const Vec<Dim, Real>& y) {
  Vec<spin<Dim>, Real> z = Vec<spin<Dim>, Real>::Zero();
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b)
      if (a != b) z[cross_axis<Dim>(a, b)] += static_cast<Real>(cross_sign<Dim>(a, b)) * x[a] * y[b];
  return z;
}

} // namespace flipbook
