// SPDX-License-Identifier: MIT
// Singular values and the polar decomposition of small matrices, and principal axes of symmetric ones, of numbers or of
// packs, without any decision that depends on them:
//   F = U diag(sigma) V^T,   F = R S,   A = U diag(values) U^T
// with rotations U, V and R (det = 1) and symmetric S and A. sigma is sorted, the largest first; of a reflection the
// last one is negative, so that R is the rotation nearest to F. The values of principal axes are in no order.
//
// 2D: R turns by the angle of (F_00 + F_11, F_10 - F_01), which makes S symmetric; then S is turned to its axes.
// 3D: rotations V by which the columns of F V become orthogonal (one-sided Jacobi), then U by a QR decomposition of F V
// [as McAdams et al. 2011 end theirs]: F^T F, which loses what is small, is never formed. The polar decomposition is
// Newton's iteration R <- (R + R^-T) / 2 where F is well inside of what it converges for, and comes from U and V
// elsewhere. Principal axes: Jacobi's rotations.
#pragma once

#include "sim/core/square.h"

#include <limits>
#include <type_traits>

namespace flipbook {

template <int Dim, class T> struct Svd {
  Square<Dim, T> U;
  std::array<T, Dim> sigma;
  Square<Dim, T> V;
};
template <int Dim, class T> struct Polar { Square<Dim, T> R, S; };
template <int Dim, class T> struct PrincipalAxes {
  Square<Dim, T> U;
  std::array<T, Dim> values;
};

namespace detail {

template <class T> [[nodiscard]] [[gnu::always_inline]] inline T root(const T& x) {
  using std::sqrt;
  return sqrt(x);
}
template <class T> [[nodiscard]] [[gnu::always_inline]] inline T magnitude(const T& x) {
  using std::abs;
  return abs(x);
}

/// Cosine and sine of the angle of (x, y); 1 and 0 where both vanish. Scaled, so that squares neither overflow nor
/// vanish.
template <class T> struct Angle {
  T c, s, r; ///< x = r c, y = r s

  [[gnu::always_inline]] Angle(const T& x, const T& y) {
    const T ax = magnitude(x), ay = magnitude(y), most = choose(ax > ay, ax, ay);
    const auto nothing = !(most > T(0));
    const T scale = choose(nothing, T(1), most), u = x / scale, v = y / scale, length = root(u * u + v * v);
    c = choose(nothing, T(1), u / choose(nothing, T(1), length));
    s = choose(nothing, T(0), v / choose(nothing, T(1), length));
    r = choose(nothing, T(0), length * scale);
  }
};

/// Columns a and b of M <- their combinations (c a + s b, c b - s a).
template <std::size_t a, std::size_t b, class T>
[[gnu::always_inline]] inline void turn_columns(Square<3, T>& M, const T& c, const T& s) {
  for (std::size_t k = 0; k < 3; ++k) {
    const T x = M[k][a], y = M[k][b];
    M[k][a] = c * x + s * y;
    M[k][b] = c * y - s * x;
  }
}

/// The smaller one of the turns that make a symmetric matrix of two rows diagonal: tan 2x = 2 off / difference, for its
/// entry beside the diagonal and the difference of those on it. The larger entry becomes larger by t off.
template <class T> struct SmallTurn {
  T t, c, s; ///< tangent, cosine, sine

  [[gnu::always_inline]] SmallTurn(const T& difference, const T& off) {
    constexpr auto tiny = std::numeric_limits<NumberOf<T>>::min();
    const T half = T(0.5) * difference, length = root(multiply_add(half, half, off * off));
    t = choose(half < T(0), -off, off) / (magnitude(half) + length + T(tiny));
    c = T(1) / root(multiply_add(t, t, T(1)));
    s = t * c;
  }
};

/// Turns columns a and b of M so that they become orthogonal; V takes the turn.
template <std::size_t a, std::size_t b, class T>
[[gnu::always_inline]] inline void orthogonalise(Square<3, T>& M, Square<3, T>& V) {
  T aa(0), bb(0), ab(0);
  for (std::size_t k = 0; k < 3; ++k) {
    aa = multiply_add(M[k][a], M[k][a], aa);
    bb = multiply_add(M[k][b], M[k][b], bb);
    ab = multiply_add(M[k][a], M[k][b], ab);
  }
  const SmallTurn<T> turn(aa - bb, ab);
  turn_columns<a, b>(M, turn.c, turn.s);
  turn_columns<a, b>(V, turn.c, turn.s);
}

/// Rows a and b of M turned so that M_ba becomes 0 and M_aa is not negative; U takes the turn, M' = turn M, U' = U
/// turn^T.
template <std::size_t a, std::size_t b, class T>
[[gnu::always_inline]] inline void eliminate(Square<3, T>& M, Square<3, T>& U) {
  const Angle<T> angle(M[a][a], M[b][a]);
  for (std::size_t k = 0; k < 3; ++k) {
    const T x = M[a][k], y = M[b][k];
    M[a][k] = angle.c * x + angle.s * y;
    M[b][k] = angle.c * y - angle.s * x;
  }
  turn_columns<a, b>(U, angle.c, angle.s);
}

/// Columns a < b of M and V in the order of the lengths of those of M.
template <std::size_t a, std::size_t b, class T>
[[gnu::always_inline]] inline void sort_columns(Square<3, T>& M, Square<3, T>& V) {
  T x(0), y(0);
  for (std::size_t k = 0; k < 3; ++k) x += M[k][a] * M[k][a], y += M[k][b] * M[k][b];
  const auto swap = x < y;
  for (Square<3, T>* each : {&M, &V})
    for (std::size_t k = 0; k < 3; ++k) {
      const T u = (*each)[k][a], v = (*each)[k][b];
      (*each)[k][a] = choose(swap, v, u);
      (*each)[k][b] = choose(swap, -u, v); // a quarter turn: V stays a rotation
    }
}

} // namespace detail

template <class T> [[nodiscard]] [[gnu::always_inline]] inline Polar<2, T> polar(const Square<2, T>& F) {
  const detail::Angle<T> angle(F[0][0] + F[1][1], F[1][0] - F[0][1]);
  const T c = angle.c, s = angle.s;
  const T off =
      T(0.5) * ((c * F[0][1] + s * F[1][1]) + (c * F[1][0] - s * F[0][0])); // both are the same up to rounding
  return {{{{{c, -s}, {s, c}}}}, {{{{c * F[0][0] + s * F[1][0], off}, {off, c * F[1][1] - s * F[0][1]}}}}};
}

/// A must be symmetric; values[0] >= values[1].
template <class T> [[nodiscard]] [[gnu::always_inline]] inline PrincipalAxes<2, T> principal(const Square<2, T>& A) {
  const T half = T(0.5) * (A[0][0] - A[1][1]), mean = T(0.5) * (A[0][0] + A[1][1]);
  const detail::Angle<T> twice(half, A[0][1]); // of twice the angle of the axes
  // cos^2 = (1 + cos 2x) / 2 where that does not cancel, else sin^2.
  const T large = detail::root(T(0.5) * (T(1) + detail::magnitude(twice.c))), small = T(0.5) * twice.s / large;
  const auto wide = twice.c < T(0);
  const auto down = twice.s < T(0);
  const T c = choose(wide, detail::magnitude(small), large), s = choose(wide, choose(down, -large, large), small);
  return {{{{{c, -s}, {s, c}}}}, {mean + twice.r, mean - twice.r}};
}

template <class T> [[nodiscard]] [[gnu::always_inline]] inline Svd<2, T> svd(const Square<2, T>& F) {
  const Polar<2, T> p = polar(F);
  const PrincipalAxes<2, T> axes = principal(p.S);
  return {p.R * axes.U, axes.values, axes.U};
}

/// Long enough to be called: so it is compiled once, not once for each material that uses it.
template <class T> [[nodiscard]] [[gnu::noinline]] Svd<3, T> svd(const Square<3, T>& F) {
  // Squares must neither overflow nor vanish.
  T scale(0);
  for (const auto& row : F.rows)
    for (const T& x : row) scale = choose(detail::magnitude(x) > scale, detail::magnitude(x), scale);
  scale = choose(scale > T(0), scale, T(1));
  Square<3, T> M = (T(1) / scale) * F, U = identity<3, T>(), V = U;
  constexpr int sweeps = std::is_same_v<NumberOf<T>, float> ? 4 : 6;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    detail::orthogonalise<0, 1>(M, V);
    detail::orthogonalise<0, 2>(M, V);
    detail::orthogonalise<1, 2>(M, V);
  }
  detail::sort_columns<0, 1>(M, V);
  detail::sort_columns<0, 2>(M, V);
  detail::sort_columns<1, 2>(M, V);
  detail::eliminate<0, 1>(M, U);
  detail::eliminate<0, 2>(M, U);
  detail::eliminate<1, 2>(M, U);
  return {U, {scale * M[0][0], scale * M[1][1], scale * M[2][2]}, V};
}

namespace detail {
/// Turns the axes p and q of A, which is symmetric, so that A_pq vanishes; U takes the turn.
template <std::size_t p, std::size_t q, class T>
[[gnu::always_inline]] inline void diagonalise(Square<3, T>& A, Square<3, T>& U) {
  constexpr std::size_t r = 3 - p - q;
  const T off = A[p][q], apr = A[p][r], aqr = A[q][r];
  const SmallTurn<T> turn(A[p][p] - A[q][q], off);
  A[p][p] = multiply_add(turn.t, off, A[p][p]);
  A[q][q] -= turn.t * off;
  A[p][q] = A[q][p] = T(0);
  A[p][r] = A[r][p] = turn.c * apr + turn.s * aqr;
  A[q][r] = A[r][q] = turn.c * aqr - turn.s * apr;
  turn_columns<p, q>(U, turn.c, turn.s);
}
} // namespace detail

/// A must be symmetric. The values are exact to what rounding makes of the largest entry.
template <class T> [[nodiscard]] [[gnu::noinline]] PrincipalAxes<3, T> principal(Square<3, T> A) {
  Square<3, T> U = identity<3, T>();
  constexpr int sweeps = std::is_same_v<NumberOf<T>, float> ? 4 : 5;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    detail::diagonalise<0, 1>(A, U);
    detail::diagonalise<0, 2>(A, U);
    detail::diagonalise<1, 2>(A, U);
  }
  return {U, {A[0][0], A[1][1], A[2][2]}};
}

namespace detail {
/// det(A) A^-T
template <class T> [[nodiscard]] [[gnu::always_inline]] inline Square<3, T> cofactors(const Square<3, T>& A) {
  return square<3, T>([&](std::size_t a, std::size_t b) {
    const std::size_t i = (a + 1) % 3, j = (a + 2) % 3, k = (b + 1) % 3, l = (b + 2) % 3;
    return A[i][k] * A[j][l] - A[i][l] * A[j][k];
  });
}

/// For matrices whose determinant is not small against their entries.
template <class T> [[nodiscard]] [[gnu::always_inline]] inline Square<3, T> rotation_by_newton(Square<3, T> R) {
  constexpr int scaled = 2, plain = std::is_same_v<NumberOf<T>, float> ? 4 : 5;
  for (int i = 0; i < scaled + plain; ++i) {
    const Square<3, T> C = cofactors(R);
    const T inverse = T(1) / (R[0][0] * C[0][0] + R[0][1] * C[0][1] + R[0][2] * C[0][2]);
    T g(0.5), h = T(0.5) * inverse;
    if (i < scaled) { // by the norms of R and of its inverse, which brings both near those of a rotation
      const T scale = root(magnitude(inverse) * root(squared_norm(C) / squared_norm(R)));
      g *= scale, h = h / scale;
    }
    R = g * R + h * C;
  }
  return R;
}
} // namespace detail

template <class T> [[nodiscard]] [[gnu::noinline]] Polar<3, T> polar(const Square<3, T>& F) {
  constexpr auto small = NumberOf<T>(1e-3); // of det F, against the cube of the mean length of its columns
  const T mean = detail::root(squared_norm(F) * T(NumberOf<T>(1) / 3));
  const auto well =
      determinant(F) > T(small) * mean * mean * mean && mean > T(NumberOf<T>(1e-8)) && mean < T(NumberOf<T>(1e8));
  Square<3, T> R = detail::rotation_by_newton(
      square<3, T>([&](std::size_t a, std::size_t b) { return choose(well, F[a][b], T(a == b ? 1 : 0)); }));
  if (any_of(!well)) {
    const Svd<3, T> s = svd(F);
    const Square<3, T> exact = times_transposed(s.U, s.V);
    R = square<3, T>([&](std::size_t a, std::size_t b) { return choose(well, R[a][b], exact[a][b]); });
  }
  const Square<3, T> S = transposed_times(R, F);
  return {R, square<3, T>([&](std::size_t a, std::size_t b) { return T(0.5) * (S[a][b] + S[b][a]); })};
}

} // namespace flipbook
