// SPDX-License-Identifier: MIT
// Packs of numbers, one for each of as many particles as a register holds, to load, to store and to find samples by.
//
// They are xsimd's: packaged by Debian 12 and 13, headers only, operators like those of numbers, every instruction set
// that we build for. What moves numbers between lanes is the compiler's (shuffles.h): xsimd's zip_lo and zip_hi mean
// something else in each of its versions, and its gathers are slow ones.
#pragma once

#include "sim/core/value.h"

#include <xsimd/xsimd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace flipbook {

template <class Real> using Pack = xsimd::batch<Real>;

template <class T> inline constexpr std::size_t lanes_of = 1;
template <class Real> inline constexpr std::size_t lanes_of<xsimd::batch<Real>> = xsimd::batch<Real>::size;

/// Positions in an array, one for each lane.
template <class T>
using PlaceOf = std::conditional_t<is_pack<T>, std::array<std::int32_t, lanes_of<T>>, std::ptrdiff_t>;

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
/// N numbers as the compiler knows them.
template <class Real, std::size_t N> struct Numbers {
  typedef Real Type __attribute__((vector_size(N * sizeof(Real))));
};

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

/// As many numbers as a pack in double has, but in a precision of their own.
template <class Real> using Narrow = typename detail::Numbers<Real, lanes_of<Pack<double>>>::Type;

/// load() of them.
template <class Real>
[[nodiscard]] [[gnu::always_inline]] inline Narrow<Real> load_narrow(const Real* p, std::size_t many) {
  constexpr std::size_t lanes = lanes_of<Pack<double>>;
  Narrow<Real> x;
  if (many >= lanes)
    std::memcpy(&x, p, sizeof x);
  else
    for (std::size_t l = 0; l < lanes; ++l) x[l] = p[l < many ? l : 0];
  return x;
}
[[nodiscard]] inline Pack<double> in_double(const Narrow<double>& x) {
  return Pack<double>(x);
}
[[nodiscard]] inline Pack<double> in_double(const Narrow<float>& x) {
#ifdef __AVX__ // where g++ 12 would take the halves through memory
  return Pack<double>(_mm256_cvtps_pd(x));
#else
  return Pack<double>(__builtin_convertvector(x, Narrow<double>));
#endif
}
template <class Real>
[[nodiscard]] [[gnu::always_inline]] inline Pack<double> load_in_double(const Real* p, std::size_t many) {
  return in_double(load_narrow(p, many));
}

/// The lanes added up, one after the other.
template <class Real> [[nodiscard]] inline Real sum_of(const xsimd::batch<Real>& x) {
  std::array<Real, lanes_of<Pack<Real>>> number;
  x.store_unaligned(number.data());
  Real sum = 0;
  for (const Real n : number) sum += n;
  return sum;
}

} // namespace flipbook
