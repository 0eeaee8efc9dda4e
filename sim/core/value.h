// SPDX-License-Identifier: MIT
// The value type of a formula: one number, or a pack of numbers, one for each of as many particles as a register holds
// (pack.h). A formula written once over `T` serves both, so that the hot sweeps read like the papers and run on packs.
// Functions of packs are found by the type of their arguments: nothing here needs the library that packs come from.
#pragma once

#include <cmath>
#include <type_traits>

namespace flipbook {

template <class T> inline constexpr bool is_pack = !std::is_floating_point_v<T>;

template <class T> struct ValueTraits { using Number = typename T::value_type; };
template <> struct ValueTraits<float> { using Number = float; };
template <> struct ValueTraits<double> { using Number = double; };
template <class T> using NumberOf = typename ValueTraits<T>::Number; ///< float or double

/// The whole number at or below q; 0 <= q < 2^31.
template <class T> [[nodiscard]] inline T whole(T q) {
  if constexpr (is_pack<T>)
    return trunc(q);
  else
    return static_cast<T>(static_cast<int>(q));
}

/// The largest whole number not above x.
template <class T> [[nodiscard]] inline T round_down(const T& x) {
  using std::floor;
  return floor(x);
}

/// Where the condition holds a, else b.
template <class Condition, class T> [[nodiscard]] inline T choose(const Condition& condition, const T& a, const T& b) {
  if constexpr (is_pack<T>)
    return select(condition, a, b);
  else
    return condition ? a : b;
}

/// Does the condition hold in any lane?
template <class Condition> [[nodiscard]] inline bool any_of(const Condition& condition) {
  if constexpr (std::is_same_v<Condition, bool>)
    return condition;
  else
    return any(condition);
}

/// a b + c; of packs rounded once where the processor can.
template <class T> [[nodiscard]] inline T multiply_add(const T& a, const T& b, const T& c) {
  if constexpr (is_pack<T>)
    return fma(a, b, c);
  else
    return a * b + c;
}

} // namespace flipbook
