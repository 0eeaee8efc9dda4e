// SPDX-License-Identifier: MIT
// Singular values and the polar decomposition: what they promise, against Eigen's, for numbers and for every lane of a
// pack, for whatever a particle may come to.
#include "sim/core/pack.h"
#include "sim/core/random.h"
#include "sim/core/svd.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace flipbook {
namespace {

template <class Real_, int Dim_> struct Case {
  using Real = Real_;
  static constexpr int Dim = Dim_;
};
using Cases = testing::Types<Case<float, 2>, Case<double, 2>, Case<float, 3>, Case<double, 3>>;
template <class C> class SvdTest : public testing::Test {};
TYPED_TEST_SUITE(SvdTest, Cases);

template <class Real> constexpr Real eps = std::numeric_limits<Real>::epsilon();
/// Of orthogonality, and of what is put together again against the largest entry.
template <class Real> constexpr Real tolerance = Real(48) * eps<Real>;

template <int Dim, class Real> Real largest(const Square<Dim, Real>& m) {
  Real most = 0;
  for (const auto& row : m.rows)
    for (const Real x : row) most = std::isnan(x) ? std::numeric_limits<Real>::infinity() : std::max(most, std::abs(x));
  return most;
}

// === Matrices

/// In (-1, 1).
double number(std::uint64_t seed, std::uint64_t n) {
  return 2 * uniform(20160704, seed, n) - 1;
}
template <int Dim, class Real> Square<Dim, Real> random_matrix(std::uint64_t seed) {
  return square<Dim, Real>([&](std::size_t a, std::size_t b) { return static_cast<Real>(number(seed, 3 * a + b)); });
}
/// U diag(sigma) V^T with the rotations of a random matrix, put together in double.
template <int Dim, class Real> Square<Dim, Real> with_values(const std::array<double, Dim>& sigma, std::uint64_t seed) {
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  Matrix M;
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b) M(a, b) = number(seed, static_cast<std::uint64_t>(3 * a + b));
  const Eigen::JacobiSVD<Matrix> s(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix U = s.matrixU(), V = s.matrixV();
  if (U.determinant() < 0) U.col(0) *= -1;
  if (V.determinant() < 0) V.col(0) *= -1;
  Matrix D = Matrix::Zero();
  for (int a = 0; a < Dim; ++a) D(a, a) = sigma[static_cast<std::size_t>(a)];
  const Matrix F = U * D * V.transpose();
  return square<Dim, Real>([&](std::size_t a, std::size_t b) {
    return static_cast<Real>(F(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
  });
}
/// x, y and (in 3D) z.
template <int Dim> std::array<double, Dim> values(double x, double y, double z) {
  if constexpr (Dim == 2)
    return {x, z};
  else
    return {x, y, z};
}

/// Every matrix of -1, 0 and 1: all ranks, equal singular values, reflections, permutations.
template <int Dim, class Real> std::vector<Square<Dim, Real>> small_integers() {
  std::vector<Square<Dim, Real>> all;
  const int count = Dim == 2 ? 81 : 19683;
  for (int n = 0; n < count; ++n) {
    int rest = n;
    all.push_back(square<Dim, Real>([&](std::size_t, std::size_t) {
      const auto digit = static_cast<Real>(rest % 3 - 1);
      rest /= 3;
      return digit;
    }));
  }
  return all;
}

/// Random ones, near and far from rotations, reflected, degenerate to rounding, graded, tiny and huge.
template <int Dim, class Real> std::vector<Square<Dim, Real>> all_kinds() {
  auto all = small_integers<Dim, Real>();
  const double far = std::is_same_v<Real, float> ? 1e30 : 1e150;
  for (std::uint64_t n = 0; n < 4000; ++n) {
    const auto random = random_matrix<Dim, Real>(n);
    all.push_back(random);
    all.push_back(with_values<Dim, Real>(values<Dim>(1.1, 1 + 1e-3 * number(n, 9), 0.9), n)); // as elastic bodies are
    all.push_back(with_values<Dim, Real>(values<Dim>(1, 0.7, -0.2), n));                      // inverted
    all.push_back(with_values<Dim, Real>(values<Dim>(2, 2, n % 2 == 0 ? 2 : -2), n));         // equal
    all.push_back(with_values<Dim, Real>(values<Dim>(1, 1, 1e-4 * number(n, 9)), n));         // flat
    all.push_back(with_values<Dim, Real>(values<Dim>(1, 1e-5 * number(n, 9), 1e-11), n));
    all.push_back(with_values<Dim, Real>(values<Dim>(3, number(n, 9), 0), n)); // without a rank to rounding
    for (const double scale : {1e-15, 1e15, 1 / far, far}) all.push_back(static_cast<Real>(scale) * random);
  }
  return all;
}

// === What must hold

template <int Dim, class Real> void expect_rotation(const Square<Dim, Real>& R, Real within) {
  EXPECT_LE(largest(transposed_times(R, R) - identity<Dim, Real>()), within);
  EXPECT_NEAR(determinant(R), Real(1), within);
}

template <int Dim, class Real> std::array<Real, Dim> eigen_values(const Square<Dim, Real>& F) {
  Eigen::Matrix<double, Dim, Dim> M;
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t b = 0; b < Dim; ++b)
      M(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = static_cast<double>(F[a][b]);
  const auto s = Eigen::JacobiSVD<Eigen::Matrix<double, Dim, Dim>>(M).singularValues();
  std::array<Real, Dim> sigma;
  for (std::size_t a = 0; a < Dim; ++a) sigma[a] = static_cast<Real>(s[static_cast<Eigen::Index>(a)]);
  return sigma;
}

/// `scale`: of rounding errors, the largest entry of F.
template <int Dim, class Real> void expect_svd(const Square<Dim, Real>& F, const Svd<Dim, Real>& s) {
  const Real scale = largest(F), within = tolerance<Real>;
  expect_rotation(s.U, within);
  expect_rotation(s.V, within);
  EXPECT_LE(largest(times_transposed(s.U * diagonal<Dim, Real>(s.sigma), s.V) - F), within * scale);
  const auto expected = eigen_values(F);
  for (std::size_t d = 0; d < Dim; ++d) {
    EXPECT_LE(std::abs(std::abs(s.sigma[d]) - expected[d]), within * scale) << d;
    if (d + 1 < Dim) {
      EXPECT_GE(s.sigma[d], std::abs(s.sigma[d + 1]) - within * scale) << d;
      EXPECT_GE(s.sigma[d], Real(0)) << d;
    }
  }
}

template <int Dim, class Real> void expect_polar(const Square<Dim, Real>& F, const Polar<Dim, Real>& p) {
  const Real scale = largest(F), within = tolerance<Real>;
  expect_rotation(p.R, within);
  EXPECT_LE(largest(p.R * p.S - F), within * scale);
  EXPECT_EQ(largest(p.S - transposed(p.S)), Real(0));
  // tr R^T F is largest for the nearest rotation: the sum of the singular values, the last with the sign of det F.
  const auto sigma = eigen_values(F);
  Real sum = sigma[Dim - 1];
  // Where the sign is not known to rounding, the value is as small.
  const Real det = determinant(
      square<Dim, Real>([&](std::size_t a, std::size_t b) { return scale > 0 ? F[a][b] / scale : Real(0); }));
  if (det < 0) sum = -sum;
  for (std::size_t d = 0; d + 1 < Dim; ++d) sum += sigma[d];
  const Real unsure = std::abs(det) < 8 * eps<Real> ? 2 * sigma[Dim - 1] : Real(0);
  EXPECT_NEAR(trace(p.S), sum, 4 * within * scale + unsure);
}

// === Packs

template <int Dim, class Real>
Square<Dim, Pack<Real>> packed(const std::vector<Square<Dim, Real>>& all, std::size_t first) {
  return square<Dim, Pack<Real>>([&](std::size_t a, std::size_t b) {
    std::array<Real, lanes_of<Pack<Real>>> lane;
    for (std::size_t l = 0; l < lane.size(); ++l) lane[l] = all[(first + l) % all.size()][a][b];
    return Pack<Real>::load_unaligned(lane.data());
  });
}
template <class Real> Real lane(const Pack<Real>& x, std::size_t l) {
  std::array<Real, lanes_of<Pack<Real>>> all;
  x.store_unaligned(all.data());
  return all[l];
}
template <int Dim, class Real> Square<Dim, Real> lane(const Square<Dim, Pack<Real>>& m, std::size_t l) {
  return square<Dim, Real>([&](std::size_t a, std::size_t b) { return lane<Real>(m[a][b], l); });
}
template <int Dim, class Real> Svd<Dim, Real> lane(const Svd<Dim, Pack<Real>>& s, std::size_t l) {
  std::array<Real, Dim> sigma;
  for (std::size_t d = 0; d < Dim; ++d) sigma[d] = lane<Real>(s.sigma[d], l);
  return {lane<Dim, Real>(s.U, l), sigma, lane<Dim, Real>(s.V, l)};
}

template <int Dim, class Real> std::string text(const Square<Dim, Real>& F) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& row : F.rows)
    for (const Real x : row) out << x << ' ';
  return out.str();
}

// ===

TYPED_TEST(SvdTest, PutsEveryKindOfMatrixTogetherAgain) {
  constexpr int Dim = TypeParam::Dim;
  for (const auto& F : all_kinds<Dim, typename TypeParam::Real>()) {
    expect_svd(F, svd(F));
    if (testing::Test::HasFailure()) FAIL() << text(F);
  }
}

TYPED_TEST(SvdTest, PolarFindsTheNearestRotation) {
  constexpr int Dim = TypeParam::Dim;
  for (const auto& F : all_kinds<Dim, typename TypeParam::Real>()) {
    expect_polar(F, polar(F));
    if (testing::Test::HasFailure()) FAIL() << text(F);
  }
}

/// Lanes beside each other are of all kinds: none may spoil another.
TYPED_TEST(SvdTest, EveryLaneHoldsItsOwn) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  const auto all = all_kinds<Dim, Real>();
  for (std::size_t first = 0; first < all.size(); first += lanes_of<Pack<Real>>) {
    const auto F = packed(all, first);
    const auto s = svd(F);
    const auto p = polar(F);
    for (std::size_t l = 0; l < lanes_of<Pack<Real>>; ++l) {
      const auto own = lane<Dim, Real>(F, l);
      expect_svd(own, lane<Dim, Real>(s, l));
      expect_polar(own, Polar<Dim, Real>{lane<Dim, Real>(p.R, l), lane<Dim, Real>(p.S, l)});
      if (testing::Test::HasFailure()) FAIL() << text(own);
    }
  }
}

TYPED_TEST(SvdTest, LanesAreWhatNumbersGive) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  std::vector<Square<Dim, Real>> all;
  for (std::uint64_t n = 0; n < 1000; ++n) // singular values well apart: elsewhere U and V are a matter of rounding
    all.push_back(with_values<Dim, Real>(values<Dim>(1.5, 1, n % 2 == 0 ? 0.5 : -0.5), n));
  const Real within = 256 * eps<Real>;
  for (std::size_t first = 0; first < all.size(); first += lanes_of<Pack<Real>>) {
    const auto F = packed(all, first);
    const auto s = svd(F);
    const auto p = polar(F);
    for (std::size_t l = 0; l < lanes_of<Pack<Real>>; ++l) {
      const auto own = lane<Dim, Real>(F, l);
      const Svd<Dim, Real> one = svd(own), of_pack = lane<Dim, Real>(s, l);
      EXPECT_LE(largest(one.U - of_pack.U), within) << text(own);
      EXPECT_LE(largest(one.V - of_pack.V), within) << text(own);
      for (std::size_t d = 0; d < Dim; ++d) EXPECT_NEAR(one.sigma[d], of_pack.sigma[d], within) << text(own);
      EXPECT_LE(largest(polar(own).R - lane<Dim, Real>(p.R, l)), within) << text(own);
      EXPECT_LE(largest(polar(own).S - lane<Dim, Real>(p.S, l)), within) << text(own);
    }
  }
}

TYPED_TEST(SvdTest, PrincipalAxesOfSymmetricMatrices) {
  constexpr int Dim = TypeParam::Dim;
  using Real = typename TypeParam::Real;
  const auto expect_axes = [](const Square<Dim, Real>& A, const PrincipalAxes<Dim, Real>& axes) {
    const Real within = tolerance<Real>;
    expect_rotation(axes.U, within);
    EXPECT_LE(largest(squared(axes.U, axes.values) - A), within * largest(A));
  };
  std::vector<Square<Dim, Real>> all;
  for (const auto& F : all_kinds<Dim, Real>())
    if (largest(F) < Real(1e18) && largest(F) > Real(1e-18)) all.push_back(F + transposed(F));
  for (std::uint64_t n = 0; n < 4000; ++n) all.push_back(squared(random_matrix<Dim, Real>(n)));
  for (std::size_t first = 0; first < all.size(); first += lanes_of<Pack<Real>>) {
    const auto A = packed(all, first);
    const auto axes = principal(A);
    for (std::size_t l = 0; l < lanes_of<Pack<Real>>; ++l) {
      const auto own = lane<Dim, Real>(A, l);
      expect_axes(own, principal(own));
      std::array<Real, Dim> values;
      for (std::size_t d = 0; d < Dim; ++d) values[d] = lane<Real>(axes.values[d], l);
      expect_axes(own, {lane<Dim, Real>(axes.U, l), values});
      if (testing::Test::HasFailure()) FAIL() << text(own);
    }
  }
}

/// F^T F would lose what is below the root of eps.
TEST(Svd, KeepsTheDigitsOfSmallValues) {
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const auto Q = with_values<3, double>({1, 1, 1}, n);
    const auto F = Q * diagonal<3, double>({1, 1e-7, 1e-14});
    const auto s = svd(F);
    EXPECT_NEAR(s.sigma[1] * 1e7, 1, 1e-13);
    EXPECT_NEAR(s.sigma[2] * 1e14, 1, 1e-13);
  }
}

TEST(Polar, OfARotationIsTheRotation) {
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const auto Q = with_values<3, double>({1, 1, 1}, n);
    EXPECT_LE(largest(polar(Q).R - Q), 4e-15);
    const double angle = 3.2 * number(n, 0), c = std::cos(angle), s = std::sin(angle);
    const Square<2, double> turn{{{{c, -s}, {s, c}}}};
    EXPECT_LE(largest(polar(turn).R - turn), 1e-15);
  }
}

} // namespace
} // namespace flipbook
