// SPDX-License-Identifier: MIT
// What a pack of particles paints on the samples of one component, and how it gets there. Samples along x are
// neighbours in memory, so what one particle leaves on a row of them,
//   (m u)_i = w_i m (v + A r_i),   m_i = w_i m   with w_i = w_x w_row,
// is a sum of a few rows that all its rows share, times numbers that change from row to row:
//   none        m w_row (w_x v, w_x)
//   affine      m w_row (w_x (v + s_x r_x), w_x) + m w_row b (w_x, 0)                  b: what the other axes paint
//   polynomial  m w_row (w_x v, w_x) + m w_row b (w_x, 0) + m w_row c (w_x r_x, 0)
//   stress      s_x w_row (g_x, w_x) + b (w_x, 0)        b = sum over the other axes of s_d g_d and the weights of the
//   rest
// (of a stress the second of each pair means nothing).
// Shared rows and numbers are computed for all particles of the pack at once; the rows are turned so that those of one
// particle lie side by side, and each particle in its turn adds its samples to the tile, a row at a time.
#pragma once

#include "sim/core/shuffles.h"
#include "sim/transfer/modes.h"
#include "sim/transfer/tile.h"

#include <algorithm>

namespace flipbook {

// === What the axes above x paint: at a sample of the last axis it becomes what the axes below paint
struct PaintsNothing {
  static constexpr std::size_t terms = 1; ///< shared rows, the one with the mass included
  template <int D, class T> [[nodiscard]] PaintsNothing at(const T&) const { return {}; }
};
template <int Dim, class T> struct PaintsSlopes { ///< sum_d s_d r_d
  static constexpr std::size_t terms = 2;
  std::array<T, Dim> slope;
  T sum = T(0);
  template <int D> [[nodiscard]] PaintsSlopes at(const T& r) const { return {slope, multiply_add(slope[D], r, sum)}; }
  [[nodiscard]] T number(std::size_t) const { return sum; }
};
template <int Axes, class T> struct PaintsProducts { ///< sum over sets s of axes of c_s prod_{d in s} r_d
  static constexpr std::size_t terms = 3;
  std::array<T, 1U << Axes> c;
  template <int D> [[nodiscard]] PaintsProducts<Axes - 1, T> at(const T& r) const {
    PaintsProducts<Axes - 1, T> below;
    for (std::size_t s = 0; s < below.c.size(); ++s) below.c[s] = multiply_add(r, c[s + below.c.size()], c[s]);
    return below;
  }
  [[nodiscard]] T number(std::size_t term) const { return c[term - 1]; } ///< of the x axis alone: 1, r_x
};

/// Paints sum_d s_ad g_d on component a, where g_d is the product of the weights with a second weight in place of N on
/// axis d: dN/dx_d, so that forces of a stress come out, or D^-1 N r, which is their form in MLS-MPM.
template <int Dim, class T, class SecondWeights> struct StressMode {
  using Second = SecondWeights;
  std::array<T, Dim*(Dim + 1) / 2> state; ///< the upper triangle of s, row by row

  [[nodiscard]] T entry(int a, int d) const {
    const int row = std::min(a, d), column = std::max(a, d);
    return state[static_cast<std::size_t>(row * Dim - row * (row + 1) / 2 + column)];
  }
};
template <class Mode> inline constexpr bool is_stress = false;
template <int Dim, class T, class Second> inline constexpr bool is_stress<StressMode<Dim, T, Second>> = true;

template <class Mode, class K, int Dim, class Real> class Painted {
  using TileOf = Tile<K, Dim, Real>;

public:
  using T = Pack<Real>;
  static constexpr std::size_t lanes = lanes_of<T>;

  /// Component `a` of a pack of particles in these cells along x.
  void paint(const Walk<Dim, Real>& walk, const Stencil<K, Dim, T>& stencil, int a, const T& cell, const T& mass,
             const T& v, const Mode& mode, const TileOf& tile) {
    const Reached x(stencil.axis(a, 0), cell);
    const T dx(walk.dx);
    place(stencil, a, cell, tile);
    if constexpr (Mode::mode == AffineMode::none) {
      share(x, v, T(0));
      each_row<Dim - 1>(stencil, a, mass, PaintsNothing{}, 0);
    } else if constexpr (Mode::mode == AffineMode::polynomial) {
      PaintsProducts<Dim, T> all;
      all.c[0] = T(0); // v is in the first of the shared rows
      for (unsigned s = 1; s < all.c.size(); ++s) {
        all.c[s] = mode.coefficient(a, s);
        for (unsigned rest = s; rest != 0; rest &= rest - 1) all.c[s] *= dx;
      }
      share(x, v, T(0));
      each_row<Dim - 1>(stencil, a, mass, all, 0);
    } else {
      PaintsSlopes<Dim, T> all;
      for (int d = 0; d < Dim; ++d) all.slope[static_cast<std::size_t>(d)] = mode.slope(a, d) * dx;
      share(x, v, all.slope[0]);
      each_row<Dim - 1>(stencil, a, mass, all, 0);
    }
  }

  /// The same of a stress.
  void paint(const Stencil<K, Dim, T, typename Mode::Second>& stencil, int a, const T& cell, const Mode& mode,
             const TileOf& tile) requires is_stress<Mode> {
    const Reached x(stencil.axis(a, 0), cell);
    place(stencil, a, cell, tile);
    std::array<T, width> pairs;
    pairs.fill(T(0));
    for (std::size_t i = 0; i < x.w.size(); ++i) {
      pairs[2 * i] = x.among(stencil.axis(a, 0).g, i);
      pairs[2 * i + 1] = x.w[i];
    }
    store(pairs, 0);
    each_row_of_stress<Dim - 1>(stencil, a, mode, T(1), T(0), 0);
  }

  /// The samples of the particle in lane `l`, to the sums of the component.
  void add(std::size_t l, Real* sums) const {
    std::array<std::array<Row, pieces>, terms> shared;
    for (std::size_t k = 0; k < pieces; ++k) {
      const auto row = [&](std::size_t t) {
        return Row::load_aligned(shared_[t].data() + l * width + k * lanes_of<Row>);
      };
      shared[0][k] = row(0);
      if constexpr (terms > 1) shared[1][k] = second_of_pairs(shared[0][k]);
      if constexpr (terms > 2) shared[2][k] = row(1);
    }
    Real* to = sums + static_cast<int>(place_[l]);
    for (std::size_t row = 0; row < rows; ++row) {
      std::array<Row, terms> number;
      for (std::size_t t = 0; t < terms; ++t) number[t] = Row(number_[t][row * lanes + l]);
      Real* at = to + offset(row);
      for (std::size_t k = 0; k < pieces; ++k) {
        // The sum waits for that of the particle before: it is touched last.
        Row change = number[0] * shared[0][k];
        for (std::size_t t = 1; t < terms; ++t) change = multiply_add(number[t], shared[t][k], change);
        const Row sum = Row::load_aligned(at + k * lanes_of<Row>) + change;
        sum.store_aligned(at + k * lanes_of<Row>);
      }
    }
  }

private:
  /// The x axis for all samples that particles of the cell reach: the weight of the first or of the last is 0.
  struct Reached {
    std::array<T, TileOf::reached> w;
    T later; ///< by so many, 0 or 1, the particle's own samples begin after the first of them
    T f;     ///< from the first of them

    Reached(const auto& axis, const T& cell) : later(axis.base - (cell - T(TileOf::before))), f(axis.f + later) {
      for (std::size_t i = 0; i < w.size(); ++i) w[i] = among(axis.w, i);
    }
    /// Of the particle's own weights the one at sample i, or 0.
    [[nodiscard]] T among(const auto& weights, std::size_t i) const {
      return choose(later > T(0.5), i > 0 ? weights[i - 1] : T(0), i + 1 < w.size() ? weights[i] : T(0));
    }
  };

  static constexpr std::size_t terms = [] {
    if constexpr (is_stress<Mode>)
      return std::size_t{2};
    else
      return Mode::mode == AffineMode::none         ? PaintsNothing::terms
             : Mode::mode == AffineMode::polynomial ? PaintsProducts<Dim, T>::terms
                                                    : PaintsSlopes<Dim, T>::terms;
  }();
  static constexpr std::size_t stored = terms > 2 ? 2 : 1; ///< shared rows that need a place
  static constexpr std::size_t rows = power(K::support, Dim - 1);
  static constexpr std::size_t width = TileOf::slot; ///< numbers in a row of samples
  /// A register that holds a row, or as much of it as one can.
  using Row = typename std::conditional_t<(lanes > width), xsimd::make_sized_batch<Real, width>,
                                          std::type_identity<Pack<Real>>>::type;
  static constexpr std::size_t pieces = width / lanes_of<Row>;

  /// Distance of a row of samples from the first one.
  static constexpr std::size_t offset(std::size_t row) {
    std::size_t at = 0;
    for (int d = 1; d < Dim; ++d, row /= K::support) at += row % K::support * TileOf::stride(d);
    return at;
  }

  /// Where in the tile the samples of each particle begin.
  void place(const auto& stencil, int a, const T& cell, const TileOf& tile) {
    const auto along = [&](int axis, const T& at) {
      return (at - T(static_cast<Real>(tile.origin(axis)))) * T(static_cast<Real>(TileOf::stride(axis)));
    };
    T place = along(0, cell);
    for (int d = 1; d < Dim; ++d) place += along(d, stencil.axis(a, d).base);
    place.store_aligned(place_.data());
  }

  /// Shared row `t` of each particle of the pack.
  void store(std::array<T, width>& row, std::size_t t) {
    transpose(row);
    for (std::size_t k = 0; k < width; ++k) row[k].store_aligned(shared_[t].data() + k * lanes);
  }

  /// The shared rows (w_x (v + slope r_x), w_x) and (w_x r_x, 0); (w_x, 0) is found in the first of them.
  void share(const Reached& x, const T& v, const T& slope) {
    std::array<std::array<T, width>, stored> all;
    for (auto& row : all) row.fill(T(0));
    for (std::size_t i = 0; i < x.w.size(); ++i) {
      const T r = T(static_cast<Real>(i)) - x.f;
      all[0][2 * i] = x.w[i] * multiply_add(slope, r, v);
      all[0][2 * i + 1] = x.w[i];
      if constexpr (stored > 1) all[1][2 * i] = x.w[i] * r;
    }
    for (std::size_t t = 0; t < stored; ++t) store(all[t], t);
  }

  /// The numbers of every row, from the samples of axis D down.
  template <int D, class Rest>
  void each_row(const Stencil<K, Dim, T>& stencil, int a, const T& weight, const Rest& rest, std::size_t row) {
    if constexpr (D == 0) {
      weight.store_aligned(number_[0].data() + row * lanes);
      if constexpr (terms > 1)
        for (std::size_t t = 1; t < terms; ++t) {
          const T number = weight * rest.number(t);
          number.store_aligned(number_[t].data() + row * lanes);
        }
    } else {
      const auto& s = stencil.axis(a, D);
      for (std::size_t i = 0; i < K::support; ++i)
        each_row<D - 1>(stencil, a, weight * s.w[i], rest.template at<D>(T(static_cast<Real>(i)) - s.f),
                        row + i * power(K::support, D - 1));
    }
  }

  /// `weight`: product of the weights above axis D; `sum`: of s_d g_d and the other weights of the axes above it.
  template <int D>
  void each_row_of_stress(const Stencil<K, Dim, T, typename Mode::Second>& stencil, int a, const Mode& s,
                          const T& weight, const T& sum, std::size_t row) {
    if constexpr (D == 0) {
      const T along_x = s.entry(a, 0) * weight;
      along_x.store_aligned(number_[0].data() + row * lanes);
      sum.store_aligned(number_[1].data() + row * lanes);
    } else {
      const auto& axis = stencil.axis(a, D);
      for (std::size_t i = 0; i < K::support; ++i)
        each_row_of_stress<D - 1>(stencil, a, s, weight * axis.w[i],
                                  multiply_add(sum, axis.w[i], weight * s.entry(a, D) * axis.g[i]),
                                  row + i * power(K::support, D - 1));
    }
  }

  static constexpr std::size_t alignment = sizeof(T);
  alignas(alignment) std::array<std::array<Real, lanes * width>, stored> shared_;
  alignas(alignment) std::array<std::array<Real, lanes * rows>, terms> number_;
  alignas(alignment) std::array<Real, lanes> place_;
};

} // namespace flipbook
