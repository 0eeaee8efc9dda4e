// SPDX-License-Identifier: MIT
// The grid's velocity and its gradient at any point of the domain:
//   u_a(x) = sum_i N_ai(x) u_ai,   (grad u)_ab = du_a/dx_b = sum_i dN_ai/dx_b u_ai
// Use: with_kernel(name, [&](auto k) { const Interpolator<decltype(k), Dim, Real> velocity(layout, grid, u); ...
// velocity(x) ... });
#pragma once

#include "sim/core/field.h"
#include "sim/transfer/stencil.h"

namespace flipbook {

template <class K, int Dim, class Real> class Interpolator {
public:
  /// Reads u later: u must outlive the interpolator.
  Interpolator(Layout layout, const Grid<Dim>& grid, const Components<Dim, Real>& u) : walk_(grid, layout) {
    for (std::size_t a = 0; a < Dim; ++a) u_[a] = u[a].data();
  }

  [[nodiscard]] Vec<Dim, Real> operator()(const Vec<Dim, Real>& x) const {
    std::array<Real, Dim> q;
    for (int d = 0; d < Dim; ++d) q[static_cast<std::size_t>(d)] = x[d];
    const std::array<Real, Dim> at = (*this)(q);
    Vec<Dim, Real> v;
    for (int a = 0; a < Dim; ++a) v[a] = at[static_cast<std::size_t>(a)];
    return v;
  }
  /// The same for the coordinates of a point or of a pack of points.
  template <class T> [[nodiscard]] std::array<T, Dim> operator()(const std::array<T, Dim>& x) const {
    const Stencil<K, Dim, T> stencil(walk_, walk_.position([&](std::size_t d) { return x[d]; }));
    std::array<T, Dim> v;
    for (int a = 0; a < Dim; ++a)
      v[static_cast<std::size_t>(a)] = stencil.value(walk_, a, u_[static_cast<std::size_t>(a)]);
    return v;
  }

  /// Row a is the gradient of component a.
  [[nodiscard]] Mat<Dim, Real> gradient(const Vec<Dim, Real>& x) const {
    const Stencil<K, Dim, Real, Slopes> stencil(walk_, position(x));
    Mat<Dim, Real> g;
    for (int a = 0; a < Dim; ++a) {
      const auto s = stencil.gather(walk_, a, u_[static_cast<std::size_t>(a)]);
      for (int b = 0; b < Dim; ++b) g(a, b) = s.first[static_cast<std::size_t>(b)] * walk_.inverse_dx;
    }
    return g;
  }

private:
  [[nodiscard]] std::array<Real, Dim> position(const Vec<Dim, Real>& x) const {
    return walk_.position([&](std::size_t d) { return x[static_cast<int>(d)]; });
  }

  Walk<Dim, Real> walk_;
  std::array<const Real*, Dim> u_;
};

} // namespace flipbook
