// SPDX-License-Identifier: MIT
// The grid samples around one particle, and the two walks over them. A weight is a product over the axes,
//   w_ip = N(i_0 - f_0) N(i_1 - f_1) ...
// so both walks are recursions over the axes: what belongs to one axis is computed once for a whole row, and nothing
// else knows the dimension.
#pragma once

#include "sim/core/order.h"
#include "sim/kernels/kernels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace flipbook {

/// What the walks need of a grid, in the precision of the particles.
template <int Dim, class Real> struct Walk {
  Real dx, inverse_dx;
  Real offset; ///< origin of a component's lattice on the axes that are not its own
  std::array<std::ptrdiff_t, Dim> stride;

  Walk(const Grid<Dim>& grid, Layout layout)
      : dx(static_cast<Real>(grid.dx)), inverse_dx(static_cast<Real>(1 / grid.dx)),
        offset(component_origin<Dim, Real>(layout, 0)[1]) {
    for (int d = 0; d < Dim; ++d) stride[static_cast<std::size_t>(d)] = grid.stride(d);
  }
  /// grid_position on each axis of the point whose coordinates are x(0), x(1), ...
  template <class X> [[nodiscard]] std::array<Real, Dim> position(X&& x) const {
    std::array<Real, Dim> q;
    for (std::size_t d = 0; d < Dim; ++d) q[d] = grid_position(x(d), inverse_dx);
    return q;
  }
};

// === Second weights g: what a walk sums on an axis besides N. Unused ones inline away.
struct NoSecond {
  template <class K, class Real> static constexpr auto weights(Real) { return typename K::template Weights<Real>{}; }
};
struct Slopes { ///< dN/df: the gradient of the interpolated field
  template <class K, class Real> static constexpr auto weights(Real f) { return K::slopes(f); }
};
struct AffineWeights { ///< D^-1 N (i - f): the best affine fit
  template <class K, class Real> static constexpr auto weights(Real f) { return K::affine(f); }
};
struct MultilinearWeights : AffineWeights { ///< and the sums with g on several axes at once
};
struct MomentWeights { ///< N (i - f)
  template <class K, class Real> static constexpr auto weights(Real f) { return K::moment(f); }
};

/// One axis: the samples base .. base + support - 1 and their weights for a particle at q.
template <class K, class Real, class Second> struct AxisStencil {
  int base;
  Real f; ///< q - base
  typename K::template Weights<Real> w, g;

  explicit AxisStencil(Real q)
      : base(K::base(q)), f(q - static_cast<Real>(base)), w(K::weights(f)), g(Second::template weights<K>(f)) {}
};

/// sum w u, and for each axis d the same sum with g in place of N on that axis.
template <int Dim, class Real> struct Gathered {
  Real value = 0;
  std::array<Real, Dim> first{};
};

/// sum w u, and for each set s of axes (bit d: axis d) the same sum with g in place of N on all of them.
template <int Dim, class Real> struct GatheredProducts {
  Real value = 0;
  std::array<Real, (1 << Dim) - 1> products{}; ///< of the set s at s - 1
};

/// A particle among the samples of every component. On axis d the lattice of component d has origin 0 and the lattices
/// of the other components share one origin, so two stencils per axis serve all of them.
template <class K, int Dim, class Real, class Second = NoSecond> class Stencil {
public:
  using Axis = AxisStencil<K, Real, Second>;
  using Position = std::array<Real, Dim>; ///< grid_position on each axis

  Stencil(const Walk<Dim, Real>& walk, const Position& q) : Stencil(walk, q, std::make_index_sequence<Dim>()) {}

  [[nodiscard]] const Axis& axis(int component, int d) const {
    return component == d ? own_[static_cast<std::size_t>(d)] : other_[static_cast<std::size_t>(d)];
  }
  /// D of a component's lattice on axis d, in cells squared.
  [[nodiscard]] Real second_moment(int component, int d) const { return K::second_moment(axis(component, d).f); }
  /// Array position of the first sample of a component.
  [[nodiscard]] std::ptrdiff_t first(const Walk<Dim, Real>& walk, int component) const {
    std::ptrdiff_t k = 0;
    for (int d = 0; d < Dim; ++d) k += axis(component, d).base * walk.stride[static_cast<std::size_t>(d)];
    return k;
  }

  /// Sums over the samples of a component, whose field is u; the first sums only where there are second weights.
  [[nodiscard]] auto gather(const Walk<Dim, Real>& walk, int component, const Real* u) const {
    if constexpr (std::is_same_v<Second, MultilinearWeights>) {
      const auto sums = gather_products<Dim - 1>(walk, component, u + first(walk, component));
      GatheredProducts<Dim, Real> result{sums[0], {}};
      std::copy(sums.begin() + 1, sums.end(), result.products.begin());
      return result;
    } else {
      return gather_axis<Dim - 1, !std::is_same_v<Second, NoSecond>>(walk, component, u + first(walk, component));
    }
  }
  /// sum w u alone.
  [[nodiscard]] Real value(const Walk<Dim, Real>& walk, int component, const Real* u) const {
    return gather_axis<Dim - 1, false>(walk, component, u + first(walk, component)).value;
  }

  /// m += w mass,  mu += w mass (value + slope . (i - f)): what a particle leaves on the component's samples.
  void scatter(const Walk<Dim, Real>& walk, int component, Real mass, Real value, const std::array<Real, Dim>& slope,
               Real* m, Real* mu) const {
    const std::ptrdiff_t k = first(walk, component);
    scatter_axis<Dim - 1>(walk, component, mass, value, slope, m + k, mu + k);
  }
  /// m += w mass,  mu += w mass sum_s c_s prod_{d in s} (i - f)_d over the sets s of axes.
  void scatter(const Walk<Dim, Real>& walk, int component, Real mass, const std::array<Real, 1 << Dim>& c, Real* m,
               Real* mu) const {
    const std::ptrdiff_t k = first(walk, component);
    scatter_products<Dim - 1>(walk, component, mass, c, m + k, mu + k);
  }

private:
  template <std::size_t... D>
  Stencil(const Walk<Dim, Real>& walk, const Position& q, std::index_sequence<D...>)
      : own_{Axis(q[D])...}, other_{Axis(q[D] - walk.offset)...} {}

  template <int D, bool First>
  [[nodiscard]] Gathered<Dim, Real> gather_axis(const Walk<Dim, Real>& walk, int component, const Real* u) const {
    const Axis& s = axis(component, D);
    Gathered<Dim, Real> sum;
    for (std::size_t i = 0; i < K::support; ++i) {
      Gathered<Dim, Real> row;
      if constexpr (D == 0)
        row.value = u[i];
      else
        row = gather_axis<D - 1, First>(walk, component, u + static_cast<std::ptrdiff_t>(i) * walk.stride[D]);
      sum.value += s.w[i] * row.value;
      if constexpr (First) {
        for (std::size_t d = 0; d < D; ++d) sum.first[d] += s.w[i] * row.first[d];
        sum.first[D] += s.g[i] * row.value;
      }
    }
    return sum;
  }

  template <int D>
  void scatter_axis(const Walk<Dim, Real>& walk, int component, Real mass, Real value,
                    const std::array<Real, Dim>& slope, Real* m, Real* mu) const {
    const Axis& s = axis(component, D);
    for (std::size_t i = 0; i < K::support; ++i) {
      const Real wm = s.w[i] * mass, v = value + slope[D] * (static_cast<Real>(i) - s.f);
      if constexpr (D == 0) {
        m[i] += wm;
        mu[i] += wm * v;
      } else {
        const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) * walk.stride[D];
        scatter_axis<D - 1>(walk, component, wm, v, slope, m + k, mu + k);
      }
    }
  }

  /// Entry s: the sum with g on the axes of s, which are 0 .. D.
  template <int D>
  [[nodiscard]] std::array<Real, 2 << D> gather_products(const Walk<Dim, Real>& walk, int component,
                                                         const Real* u) const {
    constexpr std::size_t lower = 1U << D;
    const Axis& s = axis(component, D);
    std::array<Real, 2 * lower> sum{};
    for (std::size_t i = 0; i < K::support; ++i) {
      std::array<Real, lower> row;
      if constexpr (D == 0)
        row[0] = u[i];
      else
        row = gather_products<D - 1>(walk, component, u + static_cast<std::ptrdiff_t>(i) * walk.stride[D]);
      for (std::size_t k = 0; k < lower; ++k) {
        sum[k] += s.w[i] * row[k];
        sum[k + lower] += s.g[i] * row[k];
      }
    }
    return sum;
  }

  /// The polynomial in the axes 0 .. D; a sample of axis D makes it one in the axes below.
  template <int D>
  void scatter_products(const Walk<Dim, Real>& walk, int component, Real mass, const std::array<Real, 2 << D>& c,
                        Real* m, Real* mu) const {
    constexpr std::size_t lower = 1U << D;
    const Axis& s = axis(component, D);
    for (std::size_t i = 0; i < K::support; ++i) {
      const Real wm = s.w[i] * mass, t = static_cast<Real>(i) - s.f;
      std::array<Real, lower> rest;
      for (std::size_t k = 0; k < lower; ++k) rest[k] = c[k] + t * c[k + lower];
      if constexpr (D == 0) {
        m[i] += wm;
        mu[i] += wm * rest[0];
      } else {
        const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) * walk.stride[D];
        scatter_products<D - 1>(walk, component, wm, rest, m + k, mu + k);
      }
    }
  }

  std::array<Axis, Dim> own_, other_;
};

} // namespace flipbook
