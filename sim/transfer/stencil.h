// SPDX-License-Identifier: MIT
// The grid samples around one particle, or around each particle of a pack, and the walk that gathers from them. A
// weight is a product over the axes,
//   w_ip = N(i_0 - f_0) N(i_1 - f_1) ...
// so the walk is a recursion over the axes: what belongs to one axis is computed once for a whole row, and nothing else
// knows the dimension. `T` is a number or a pack (core/value.h), `Real` the numbers of the grid.
#pragma once

#include "sim/core/order.h"
#include "sim/core/shuffles.h"
#include "sim/core/unrolled.h"
#include "sim/kernels/kernels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace flipbook {

/// What the walk needs of a grid, in the precision of the particles.
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
  template <class X> [[nodiscard]] auto position(X&& x) const {
    using T = std::remove_cvref_t<decltype(x(std::size_t{0}))>;
    std::array<T, Dim> q;
    for (std::size_t d = 0; d < Dim; ++d) q[d] = grid_position(x(d), inverse_dx);
    return q;
  }
};

// === Second weights g: what a walk sums on an axis besides N. Unused ones inline away.
struct NoSecond {
  template <class K, class T> static constexpr auto weights(T) { return typename K::template Weights<T>{}; }
};
struct Slopes { ///< dN/df: the gradient of the interpolated field
  template <class K, class T> static constexpr auto weights(T f) { return K::slopes(f); }
};
struct AffineWeights { ///< D^-1 N (i - f): the best affine fit
  template <class K, class T> static constexpr auto weights(T f) { return K::affine(f); }
};
struct MultilinearWeights : AffineWeights { ///< and the sums with g on several axes at once
};
struct MomentWeights { ///< N (i - f)
  template <class K, class T> static constexpr auto weights(T f) { return K::moment(f); }
};

/// One axis: the samples base .. base + support - 1 and their weights for a particle at q.
template <class K, class T, class Second> struct AxisStencil {
  T base; ///< a whole number
  T f;    ///< q - base
  typename K::template Weights<T> w, g;

  explicit AxisStencil(T q) : base(K::base(q)), f(q - base), w(K::weights(f)), g(Second::template weights<K>(f)) {}
};

/// sum w u, and for each axis d the same sum with g in place of N on that axis.
template <int Dim, class T> struct Gathered {
  T value;
  std::array<T, Dim> first;
};

/// sum w u, and for each set s of axes (bit d: axis d) the same sum with g in place of N on all of them.
template <int Dim, class T> struct GatheredProducts {
  T value;
  std::array<T, (1 << Dim) - 1> products; ///< of the set s at s - 1
};

/// A particle among the samples of every component. On axis d the lattice of component d has origin 0 and the lattices
/// of the other components share one origin, so two stencils per axis serve all of them.
template <class K, int Dim, class T, class Second = NoSecond> class Stencil {
public:
  using Real = NumberOf<T>;
  using Axis = AxisStencil<K, T, Second>;
  using Position = std::array<T, Dim>; ///< grid_position on each axis

  [[gnu::always_inline]] Stencil(const Walk<Dim, Real>& walk, const Position& q)
      : Stencil(walk, q, std::make_index_sequence<Dim>()) {}

  [[nodiscard]] const Axis& axis(int component, int d) const {
    return component == d ? own_[static_cast<std::size_t>(d)] : other_[static_cast<std::size_t>(d)];
  }
  /// D of a component's lattice on axis d, in cells squared.
  [[nodiscard]] T second_moment(int component, int d) const { return K::second_moment(axis(component, d).f); }
  /// The first sample of a component on each axis.
  [[nodiscard]] std::array<T, Dim> base(int component) const {
    std::array<T, Dim> b;
    for (int d = 0; d < Dim; ++d) b[static_cast<std::size_t>(d)] = axis(component, d).base;
    return b;
  }
  /// Where it lies in the field.
  [[nodiscard]] PlaceOf<T> first(const Walk<Dim, Real>& walk, int component) const {
    return place_of<T>(base(component), walk.stride);
  }

  /// Sums over the samples of a component, whose field is u; the first sums only where there are second weights.
  [[nodiscard]] auto gather(const Walk<Dim, Real>& walk, int component, const Real* u) const {
    if constexpr (std::is_same_v<Second, MultilinearWeights>) {
      const auto sums = gather_products<Dim - 1>(walk, component, u, first(walk, component));
      GatheredProducts<Dim, T> result{sums[0], {}};
      std::copy(sums.begin() + 1, sums.end(), result.products.begin());
      return result;
    } else {
      return gather_axis<Dim - 1, !std::is_same_v<Second, NoSecond>>(walk, component, u, first(walk, component));
    }
  }
  /// sum w u alone.
  [[nodiscard]] T value(const Walk<Dim, Real>& walk, int component, const Real* u) const {
    return gather_axis<Dim - 1, false>(walk, component, u, first(walk, component)).value;
  }

private:
  template <std::size_t... D>
  [[gnu::always_inline]] Stencil(const Walk<Dim, Real>& walk, const Position& q, std::index_sequence<D...>)
      : own_{Axis(q[D])...}, other_{Axis(q[D] - T(walk.offset))...} {}

  /// The samples of axis D from the one at u[at] on.
  template <int D, bool First>
  [[nodiscard]] Gathered<Dim, T> gather_axis(const Walk<Dim, Real>& walk, int component, const Real* u,
                                             const PlaceOf<T>& at) const {
    const Axis& s = axis(component, D);
    Gathered<Dim, T> sum;
    sum.value = T(0);
    sum.first.fill(T(0));
    std::array<T, K::support> samples;
    if constexpr (D == 0) samples = look_up_row<K::support, T>(u, at);
    for (std::size_t i = 0; i < K::support; ++i) {
      Gathered<Dim, T> row;
      if constexpr (D == 0)
        row.value = samples[i];
      else
        row = gather_axis<D - 1, First>(walk, component, u + static_cast<std::ptrdiff_t>(i) * walk.stride[D], at);
      sum.value = multiply_add(s.w[i], row.value, sum.value);
      if constexpr (First) {
        for (std::size_t d = 0; d < D; ++d) sum.first[d] = multiply_add(s.w[i], row.first[d], sum.first[d]);
        sum.first[D] = multiply_add(s.g[i], row.value, sum.first[D]);
      }
    }
    return sum;
  }

  /// Entry s: the sum with g on the axes of s, which are 0 .. D.
  template <int D>
  [[nodiscard]] std::array<T, 2 << D> gather_products(const Walk<Dim, Real>& walk, int component, const Real* u,
                                                      const PlaceOf<T>& at) const {
    constexpr std::size_t lower = 1U << D;
    const Axis& s = axis(component, D);
    std::array<T, 2 * lower> sum;
    sum.fill(T(0));
    const auto add = [&](std::size_t i, const std::array<T, lower>& row) {
      unrolled<lower>([&]<std::size_t k>() {
        sum[k] = multiply_add(s.w[i], row[k], sum[k]);
        sum[k + lower] = multiply_add(s.g[i], row[k], sum[k + lower]);
      });
    };
    if constexpr (D == 0) {
      const std::array<T, K::support> samples = look_up_row<K::support, T>(u, at);
      for (std::size_t i = 0; i < K::support; ++i) add(i, {samples[i]});
    } else {
      for (std::size_t i = 0; i < K::support; ++i)
        add(i, gather_products<D - 1>(walk, component, u + static_cast<std::ptrdiff_t>(i) * walk.stride[D], at));
    }
    return sum;
  }

  std::array<Axis, Dim> own_, other_;
};

} // namespace flipbook
