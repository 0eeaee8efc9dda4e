// SPDX-License-Identifier: MIT
// The value type of a formula: one number, or a pack of numbers, one for each of as many particles as a register holds.
// A formula written once over `T` serves both, so that the hot sweeps read like the papers and run on packs.
//
// Packs are xsimd's: packaged by Debian 12 and 13, headers only, operators like those of numbers, every instruction set
// that we build for. What moves numbers between lanes is the compiler's (shuffles.h): xsimd's zip_lo and zip_hi mean
// something else in each of its versions, and its gathers are slow ones.
#pragma once

#include <xsimd/xsimd.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace flipbook {

template <class Real> using Pack = xsimd::batch<Real>;

template <class T> struct ValueTraits {
  using Number = T;
  using Place = std::ptrdiff_t;
  static constexpr std::size_t lanes = 1;
};
template <class Real> struct ValueTraits<xsimd::batch<Real>> {
  using Number = Real;
  using Place = std::array<std::int32_t, xsimd::batch<Real>::size>;
  static constexpr std::size_t lanes = xsimd::batch<Real>::size;
};

template <class T> using NumberOf = typename ValueTraits<T>::Number; ///< float or double
template <class T> using PlaceOf = typename ValueTraits<T>::Place;   ///< positions in an array, one for each lane
template <class T> inline constexpr std::size_t lanes_of = ValueTraits<T>::lanes;
template <class T> inline constexpr bool is_pack = !std::is_floating_point_v<T>;

/// The whole number at or below q; 0 <= q < 2^31.
template <class T> [[nodiscard]] inline T whole(T q) {
  if constexpr (is_pack<T>)
    return xsimd::trunc(q);
  else
    return static_cast<T>(static_cast<int>(q));
}

/// base . stride for whole numbers `base`: where a sample lies in its field, which has less than 2^31 of them.
template <class T, std::size_t Dim>
[[nodiscard]] inline PlaceOf<T> place_of(const std::array<T, Dim>& base,
                                         const std::array<std::ptrdiff_t, Dim>& stride) {
  PlaceOf<T> at{};
  if constexpr (!is_pack<T>) {
    for (std::size_t d = 0; d < Dim; ++d) at += static_cast<std::ptrdiff_t>(base[d]) * stride[d];
  } else if constexpr (sizeof(NumberOf<T>) == sizeof(std::int32_t)) { // floats could not hold the sum
    using Whole = xsimd::batch<std::int32_t>;
    Whole sum(0);
    for (std::size_t d = 0; d < Dim; ++d) sum += xsimd::to_int(base[d]) * Whole(static_cast<std::int32_t>(stride[d]));
    sum.store_unaligned(at.data());
  } else {
    T sum(0);
    for (std::size_t d = 0; d < Dim; ++d) sum += base[d] * T(static_cast<NumberOf<T>>(stride[d]));
    std::array<NumberOf<T>, lanes_of<T>> number;
    sum.store_unaligned(number.data());
    for (std::size_t l = 0; l < at.size(); ++l) at[l] = static_cast<std::int32_t>(number[l]);
  }
  return at;
}

namespace detail {
template <class T> [[gnu::noinline, gnu::cold]] T load_some(const NumberOf<T>* p, std::size_t many) {
  std::array<NumberOf<T>, lanes_of<T>> copy;
  for (std::size_t l = 0; l < lanes_of<T>; ++l) copy[l] = p[l < many ? l : 0];
  return T::load_unaligned(copy.data());
}
} // namespace detail

/// The entries of the first `many` lanes from p on; the other lanes hold the first entry again.
template <class T> [[nodiscard]] inline T load(const NumberOf<T>* p, std::size_t many) {
  if constexpr (!is_pack<T>)
    return *p;
  else
    return many >= lanes_of<T> ? T::load_unaligned(p) : detail::load_some<T>(p, many);
}

/// Where the condition holds a, else b.
template <class Condition, class T> [[nodiscard]] inline T choose(const Condition& condition, const T& a, const T& b) {
  if constexpr (is_pack<T>)
    return xsimd::select(condition, a, b);
  else
    return condition ? a : b;
}

/// Does the condition hold in any lane?
template <class Condition> [[nodiscard]] inline bool any_of(const Condition& condition) {
  if constexpr (std::is_same_v<Condition, bool>)
    return condition;
  else
    return xsimd::any(condition);
}

/// a b + c; of packs rounded once where the processor can.
template <class T> [[nodiscard]] inline T multiply_add(const T& a, const T& b, const T& c) {
  if constexpr (is_pack<T>)
    return xsimd::fma(a, b, c);
  else
    return a * b + c;
}

/// The largest whole number not above x.
template <class T> [[nodiscard]] inline T round_down(const T& x) {
  if constexpr (is_pack<T>)
    return xsimd::floor(x);
  else
    return std::floor(x);
}

} // namespace flipbook
