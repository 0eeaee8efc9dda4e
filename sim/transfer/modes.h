// SPDX-License-Identifier: MIT
// The affine modes: what a particle remembers besides its velocity (A_p), what it paints with it and how it gathers it.
// With r = x_i - x_p and the weights of component a's lattice (w_a, D_a = sum w_a r r^T, diagonal):
//
//   none    paints v_a                      gathers nothing
//   rigid   paints v_a + omega . (r x e_a)  omega = K^-1 L,  L = sum_a sum_i w_ai (r x e_a) u_ai,
//                                                            K = sum_a sum_i w_ai (r x e_a)(r x e_a)^T
//   full    paints v_a + c_a . r            c_a = sum_i D_a^-1 w_ai r u_ai      (c_a: row a of C)
//   polynomial  paints v_a + sum_s c_as r^s     c_as = sum_i w_ai (D_a^-1 r)^s u_ai,   r^s = prod_{d in s} r_d
//                                               over the non-empty sets s of axes: x, y, xy, z, ..
//
// On nodes, L and K are the angular momentum and the inertia tensor of the tech report of APIC, divided by m_p; on MAC
// faces each component uses its own samples. K is diagonal in every case, because first moments of the weights vanish.
#pragma once

#include "sim/core/cross.h"
#include "sim/core/particles.h"
#include "sim/transfer/stencil.h"

#include <limits>

namespace flipbook {

/// Remembers nothing.
template <int Dim, class T> struct NoneMode {
  static constexpr AffineMode mode = AffineMode::none;
  using Second = NoSecond;
  std::array<T, 0> state;

  [[nodiscard]] T slope(int, int) const { return T(0); }
  template <class Stencil> void gather(const Stencil&, const std::array<Gathered<Dim, T>, Dim>&, NumberOf<T>) {}
};

/// Remembers the spin omega.
template <int Dim, class T> struct RigidMode {
  static constexpr AffineMode mode = AffineMode::rigid;
  using Second = MomentWeights;
  std::array<T, spin<Dim>> state; ///< omega

  /// d(painted v_a)/dr_d = omega . (e_d x e_a).
  [[nodiscard]] T slope(int a, int d) const {
    if (a == d) return T(0);
    return cross_sign<Dim>(d, a) > 0 ? state[axis(d, a)] : -state[axis(d, a)];
  }

  template <class Stencil>
  void gather(const Stencil& stencil, const std::array<Gathered<Dim, T>, Dim>& u, NumberOf<T> inverse_dx) {
    std::array<T, spin<Dim>> L, K;
    L.fill(T(0));
    K.fill(T(0));
    for (int a = 0; a < Dim; ++a)
      for (int d = 0; d < Dim; ++d) {
        if (a == d) continue;
        const T moment = u[static_cast<std::size_t>(a)].first[static_cast<std::size_t>(d)];
        L[axis(d, a)] += cross_sign<Dim>(d, a) > 0 ? moment : -moment;
        K[axis(d, a)] += stencil.second_moment(a, d);
      }
    // K vanishes only where the particle sits on its samples (linear kernel) and omega paints nothing: a
    // pseudo-inverse.
    for (std::size_t c = 0; c < state.size(); ++c)
      state[c] = choose(K[c] > T(std::numeric_limits<NumberOf<T>>::min()), L[c] / K[c] * T(inverse_dx), T(0));
  }

private:
  static constexpr std::size_t axis(int d, int a) { return static_cast<std::size_t>(cross_axis<Dim>(d, a)); }
};

/// Remembers the velocity gradient C, row by row.
template <int Dim, class T> struct FullMode {
  static constexpr AffineMode mode = AffineMode::full;
  using Second = AffineWeights;
  std::array<T, Dim * Dim> state; ///< C

  /// d(painted v_a)/dr_d = C_ad.
  [[nodiscard]] T slope(int a, int d) const { return state[static_cast<std::size_t>(a * Dim + d)]; }

  template <class Stencil>
  void gather(const Stencil&, const std::array<Gathered<Dim, T>, Dim>& u, NumberOf<T> inverse_dx) {
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t d = 0; d < Dim; ++d) state[a * Dim + d] = u[a].first[d] * T(inverse_dx);
  }

  /// C <- (C - C^T) / 2.
  void keep_skew() {
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t d = 0; d <= a; ++d) {
        T &ad = state[a * Dim + d], &da = state[d * Dim + a];
        ad = T(0.5) * (ad - da);
        da = -ad;
      }
  }
};

/// Remembers a multilinear velocity: the coefficients of r_x, r_y, r_x r_y, .. for each component. The products are
/// orthogonal under w, because first moments of the weights vanish on every axis, so each coefficient is gathered
/// alone.
template <int Dim, class T> struct PolynomialMode {
  static constexpr AffineMode mode = AffineMode::polynomial;
  static constexpr unsigned sets = (1U << Dim) - 1; ///< non-empty sets of axes
  using Second = MultilinearWeights;
  std::array<T, Dim * sets> state;

  /// Of the product over the set s of axes, in v_a.
  [[nodiscard]] T coefficient(int a, unsigned s) const { return state[static_cast<std::size_t>(a) * sets + s - 1]; }
  [[nodiscard]] T slope(int a, int d) const { return coefficient(a, 1U << d); }

  template <class Stencil>
  void gather(const Stencil&, const std::array<GatheredProducts<Dim, T>, Dim>& u, NumberOf<T> inverse_dx) {
    for (std::size_t a = 0; a < Dim; ++a)
      for (unsigned s = 1; s <= sets; ++s) {
        T c = u[a].products[s - 1];
        for (unsigned rest = s; rest != 0; rest &= rest - 1) c *= T(inverse_dx);
        state[a * sets + s - 1] = c;
      }
  }
};

/// body(Mode{}) for the mode of that name.
template <int Dim, class T, class Body> decltype(auto) with_mode(AffineMode mode, Body&& body) {
  switch (mode) {
  case AffineMode::none: return body(NoneMode<Dim, T>{});
  case AffineMode::rigid: return body(RigidMode<Dim, T>{});
  case AffineMode::full: return body(FullMode<Dim, T>{});
  case AffineMode::polynomial: break;
  }
  return body(PolynomialMode<Dim, T>{});
}

} // namespace flipbook
