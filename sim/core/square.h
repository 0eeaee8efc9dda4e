// SPDX-License-Identifier: MIT
// Small square matrices of numbers or of packs (value.h), for what each particle computes by itself: deformation,
// stress, decompositions. Eigen's matrices take numbers only.
#pragma once

#include "sim/core/value.h"

#include <array>
#include <cstddef>
#include <type_traits>

namespace flipbook {

template <int Dim, class T> struct Square {
  std::array<std::array<T, Dim>, Dim> rows;

  [[nodiscard]] std::array<T, Dim>& operator[](std::size_t row) { return rows[row]; }
  [[nodiscard]] const std::array<T, Dim>& operator[](std::size_t row) const { return rows[row]; }
};

/// The entry (a, b) is entry(a, b).
template <int Dim, class T, class Entry>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> square(Entry&& entry) {
  Square<Dim, T> m;
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t b = 0; b < Dim; ++b) m[a][b] = entry(a, b);
  return m;
}
/// x on the diagonal.
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> diagonal(const std::array<T, Dim>& x) {
  return square<Dim, T>([&](std::size_t a, std::size_t b) { return a == b ? x[a] : T(0); });
}
template <int Dim, class T> [[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> identity() {
  return square<Dim, T>([](std::size_t a, std::size_t b) { return T(a == b ? 1 : 0); });
}
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> transposed(const Square<Dim, T>& m) {
  return square<Dim, T>([&](std::size_t a, std::size_t b) { return m[b][a]; });
}

/// A B
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> operator*(const Square<Dim, T>& A, const Square<Dim, T>& B) {
  return square<Dim, T>([&](std::size_t a, std::size_t b) {
    T sum = A[a][0] * B[0][b];
    for (std::size_t k = 1; k < Dim; ++k) sum = multiply_add(A[a][k], B[k][b], sum);
    return sum;
  });
}
/// A B^T
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> times_transposed(const Square<Dim, T>& A,
                                                                            const Square<Dim, T>& B) {
  return A * transposed(B);
}
/// A^T B
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> transposed_times(const Square<Dim, T>& A,
                                                                            const Square<Dim, T>& B) {
  return transposed(A) * B;
}
/// A A^T, the same above and below the diagonal.
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> squared(const Square<Dim, T>& A) {
  Square<Dim, T> m;
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t b = a; b < Dim; ++b) {
      T sum = A[a][0] * A[b][0];
      for (std::size_t k = 1; k < Dim; ++k) sum = multiply_add(A[a][k], A[b][k], sum);
      m[a][b] = m[b][a] = sum;
    }
  return m;
}
/// A diag(x) A^T, the same above and below the diagonal.
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> squared(const Square<Dim, T>& A,
                                                                   const std::type_identity_t<std::array<T, Dim>>& x) {
  Square<Dim, T> m;
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t b = a; b < Dim; ++b) {
      T sum = x[0] * A[a][0] * A[b][0];
      for (std::size_t k = 1; k < Dim; ++k) sum = multiply_add(x[k] * A[a][k], A[b][k], sum);
      m[a][b] = m[b][a] = sum;
    }
  return m;
}
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> operator+(const Square<Dim, T>& A, const Square<Dim, T>& B) {
  return square<Dim, T>([&](std::size_t a, std::size_t b) { return A[a][b] + B[a][b]; });
}
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> operator-(const Square<Dim, T>& A, const Square<Dim, T>& B) {
  return square<Dim, T>([&](std::size_t a, std::size_t b) { return A[a][b] - B[a][b]; });
}
template <int Dim, class T>
[[nodiscard]] [[gnu::always_inline]] inline Square<Dim, T> operator*(const T& x, const Square<Dim, T>& A) {
  return square<Dim, T>([&](std::size_t a, std::size_t b) { return x * A[a][b]; });
}

template <int Dim, class T> [[nodiscard]] [[gnu::always_inline]] inline T trace(const Square<Dim, T>& A) {
  T sum = A[0][0];
  for (std::size_t a = 1; a < Dim; ++a) sum += A[a][a];
  return sum;
}
/// A : A
template <int Dim, class T> [[nodiscard]] [[gnu::always_inline]] inline T squared_norm(const Square<Dim, T>& A) {
  T sum(0);
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t b = 0; b < Dim; ++b) sum = multiply_add(A[a][b], A[a][b], sum);
  return sum;
}
template <int Dim, class T> [[nodiscard]] [[gnu::always_inline]] inline T determinant(const Square<Dim, T>& A) {
  if constexpr (Dim == 2)
    return A[0][0] * A[1][1] - A[0][1] * A[1][0];
  else
    return A[0][0] * (A[1][1] * A[2][2] - A[1][2] * A[2][1]) + A[0][1] * (A[1][2] * A[2][0] - A[1][0] * A[2][2]) +
           A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
}

} // namespace flipbook
