// SPDX-License-Identifier: MIT
// Packs turned from one number of many particles to many numbers of one particle, and back.
#pragma once

#include "sim/core/pack.h"

#include <bit>
#include <utility>

namespace flipbook {

namespace detail {
/// Entry i of the result is entry index(i) of a and b, counted on from a to b.
template <std::size_t Out, auto index, class V> [[nodiscard]] [[gnu::always_inline]] inline auto shuffle(V a, V b) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return __builtin_shufflevector(a, b, static_cast<int>(index(i))...);
  }
  (std::make_index_sequence<Out>());
}
template <class V> [[nodiscard]] [[gnu::always_inline]] inline auto join(V a, V b) {
  return shuffle<2 * sizeof(V) / sizeof(a[0]), [](std::size_t i) { return i; }>(a, b);
}
/// Entries From, From + 1, .. of the two in turns.
template <std::size_t From, class T> [[nodiscard]] [[gnu::always_inline]] inline T in_turns(const T& a, const T& b) {
  return T(shuffle<lanes_of<T>, [](std::size_t i) { return From + i / 2 + i % 2 * lanes_of<T>; }>(a.data, b.data));
}
} // namespace detail

/// (x_1, 0, x_3, 0, ..).
template <class T> [[nodiscard]] inline T second_of_pairs(const T& x) {
  const T zero(0);
  return T(
      detail::shuffle<lanes_of<T>, [](std::size_t i) { return i % 2 == 0 ? i + 1 : lanes_of<T>; }>(x.data, zero.data));
}

/// Turns Rows packs into rows of `Rows` neighbours, one row for each lane: entry r of lane l becomes number r + Rows l
/// of the result. Rows is a power of two. Each round takes the first half of all numbers and the second in turns.
template <std::size_t Rows, class T> [[gnu::always_inline]] inline void transpose(std::array<T, Rows>& x) {
  static_assert(std::has_single_bit(Rows));
  for (std::size_t done = 1; done < Rows; done *= 2) {
    std::array<T, Rows> next;
    for (std::size_t i = 0; i < Rows / 2; ++i) {
      next[2 * i] = detail::in_turns<0>(x[i], x[i + Rows / 2]);
      next[2 * i + 1] = detail::in_turns<lanes_of<T> / 2>(x[i], x[i + Rows / 2]);
    }
    x = next;
  }
}

namespace detail {

/// Rows of N = 2 or 4 numbers, 16 bytes at most, of every lane. Registers consist of parts of 16 bytes; each is filled
/// with rows of lanes that end up in the same part of the result, so that nothing crosses from part to part.
template <class T, std::size_t N, class Row> class LaneRows {
public:
  explicit LaneRows(const Row& row) : row_(row) {}

  [[nodiscard]] std::array<T, N> columns() const {
    if constexpr (N == 2) {
      const auto a = filled(0), b = filled(1);
      return {T(shuffle<lanes, pick<0>>(a, b)), T(shuffle<lanes, pick<1>>(a, b))};
    } else {
      const auto a = filled(0), b = filled(1), c = filled(2), d = filled(3);
      const auto ab0 = shuffle<lanes, in_turns<0>>(a, b), cd0 = shuffle<lanes, in_turns<0>>(c, d);
      const auto ab2 = shuffle<lanes, in_turns<2>>(a, b), cd2 = shuffle<lanes, in_turns<2>>(c, d);
      return {T(shuffle<lanes, halves<0>>(ab0, cd0)), T(shuffle<lanes, halves<2>>(ab0, cd0)),
              T(shuffle<lanes, halves<0>>(ab2, cd2)), T(shuffle<lanes, halves<2>>(ab2, cd2))};
    }
  }

private:
  static constexpr std::size_t lanes = lanes_of<T>, part = 16 / sizeof(NumberOf<T>), rows = part / N;

  /// Entry k of every row, two rows in a part where they fit.
  template <std::size_t k>
  static constexpr auto pick = [](std::size_t i) {
    const std::size_t lane = i % part;
    return lane / rows * lanes + i / part * part + lane % rows * N + k;
  };
  template <std::size_t from>
  static constexpr auto in_turns = [](std::size_t i) { return i / 4 * 4 + i % 4 / 2 + from + i % 2 * lanes; };
  template <std::size_t from>
  static constexpr auto halves = [](std::size_t i) { return i / 4 * 4 + i % 2 + from + i % 4 / 2 * lanes; };

  [[nodiscard]] auto part_of(std::size_t i, std::size_t first) const {
    if constexpr (rows == 2)
      return join(row_(first + 2 * i), row_(first + 2 * i + 1));
    else
      return row_(first + i);
  }
  [[nodiscard]] auto filled(std::size_t i) const {
    if constexpr (lanes == part)
      return part_of(i, 0);
    else if constexpr (lanes == 2 * part)
      return join(part_of(i, 0), part_of(i, part));
    else
      return join(join(part_of(i, 0), part_of(i, part)), join(part_of(i, 2 * part), part_of(i, 3 * part)));
  }

  const Row& row_;
};

} // namespace detail

/// u[at], u[at + 1], .. u[at + N - 1] of every lane, N <= 4; the field must not end before u[at + 3] where N is 3. One
/// read for all of them and shuffles, where a processor's own gather reads them one by one.
template <std::size_t N, class T>
[[nodiscard]] [[gnu::always_inline]] inline std::array<T, N> look_up_row(const NumberOf<T>* u, const PlaceOf<T>& at) {
  using Real = NumberOf<T>;
  constexpr std::size_t read = std::bit_ceil(N);
  std::array<T, N> out;
  if constexpr (!is_pack<T>) {
    for (std::size_t i = 0; i < N; ++i) out[i] = u[at + static_cast<std::ptrdiff_t>(i)];
  } else if constexpr (read * sizeof(Real) > 16) {
    const auto first = look_up_row<2, T>(u, at), second = look_up_row<2, T>(u + 2, at);
    for (std::size_t i = 0; i < N; ++i) out[i] = i < 2 ? first[i] : second[i - 2];
  } else {
    const auto row = [&](std::size_t l) {
      typename detail::Numbers<Real, read>::Type x;
      std::memcpy(&x, u + at[l], sizeof x);
      return x;
    };
    const auto all = detail::LaneRows<T, read, decltype(row)>(row).columns();
    for (std::size_t i = 0; i < N; ++i) out[i] = all[i];
  }
  return out;
}

} // namespace flipbook
