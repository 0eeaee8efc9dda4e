// SPDX-License-Identifier: MIT
// Packs of particles: every lane holds what a single number would have given.
#include "sim/core/shuffles.h"
#include "sim/kernels/kernels.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

namespace flipbook {
namespace {

template <class Real> class PackTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(PackTest, Reals);

template <class T> std::array<NumberOf<T>, lanes_of<T>> lanes(const T& x) {
  std::array<NumberOf<T>, lanes_of<T>> all;
  x.store_unaligned(all.data());
  return all;
}

/// 7.1, 8.4, 9.7, ..: a different place in its cell for every lane.
template <class Real> Pack<Real> positions() {
  std::array<Real, lanes_of<Pack<Real>>> q;
  for (std::size_t l = 0; l < q.size(); ++l) q[l] = Real(7.1) + Real(1.3) * static_cast<Real>(l);
  return Pack<Real>::load_unaligned(q.data());
}

TYPED_TEST(PackTest, KernelsGiveEachLaneItsOwnWeights) {
  using Real = TypeParam;
  const Pack<Real> q = positions<Real>();
  for (const KernelName name : {KernelName::linear, KernelName::quadratic, KernelName::cubic})
    with_kernel(name, [&](auto kernel) {
      using K = decltype(kernel);
      const Pack<Real> base = K::base(q);
      const auto w = K::weights(q - base), dw = K::slopes(q - base), affine = K::affine(q - base);
      for (std::size_t l = 0; l < lanes_of<Pack<Real>>; ++l) {
        const Real at = lanes(q)[l];
        ASSERT_EQ(lanes(base)[l], K::base(at));
        const Real f = at - K::base(at), tolerance = 8 * std::numeric_limits<Real>::epsilon();
        for (std::size_t i = 0; i < K::support; ++i) {
          EXPECT_NEAR(lanes(w[i])[l], K::weights(f)[i], tolerance);
          EXPECT_NEAR(lanes(dw[i])[l], K::slopes(f)[i], tolerance);
          EXPECT_NEAR(lanes(affine[i])[l], K::affine(f)[i], tolerance);
        }
      }
    });
}

TYPED_TEST(PackTest, PlacesAreSumsOverTheAxes) {
  using T = Pack<TypeParam>;
  const T whole_numbers = whole(positions<TypeParam>());
  const std::array<T, 3> base{whole_numbers, T(16000), whole_numbers + T(1)};
  const std::array<std::ptrdiff_t, 3> stride{1, 401, 100000}; // sums beyond 2^22, where a float has halves no more
  const PlaceOf<T> at = place_of<T>(base, stride);
  for (std::size_t l = 0; l < lanes_of<T>; ++l) {
    const auto n = static_cast<std::ptrdiff_t>(lanes(whole_numbers)[l]);
    EXPECT_EQ(at[l], n + 16000 * 401 + (n + 1) * 100000);
    EXPECT_EQ(at[l], place_of<TypeParam>(std::array{lanes(base[0])[l], lanes(base[1])[l], lanes(base[2])[l]}, stride));
  }
}

template <std::size_t N, class Real> void expect_rows() {
  using T = Pack<Real>;
  std::vector<Real> u(200);
  std::iota(u.begin(), u.end(), Real(0));
  PlaceOf<T> at;
  for (std::size_t l = 0; l < lanes_of<T>; ++l) at[l] = static_cast<int>(l * l * 3 + 1);
  const auto row = look_up_row<N, T>(u.data(), at);
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t l = 0; l < lanes_of<T>; ++l)
      EXPECT_EQ(lanes(row[i])[l], static_cast<Real>(at[l]) + static_cast<Real>(i));
}

TYPED_TEST(PackTest, RowsOfTheFieldAreLookedUpForEveryLane) {
  expect_rows<2, TypeParam>();
  expect_rows<3, TypeParam>();
  expect_rows<4, TypeParam>();
}

template <std::size_t Rows, class Real> void expect_turned() {
  using T = Pack<Real>;
  std::array<Real, lanes_of<T>> number;
  std::array<T, Rows> x;
  for (std::size_t r = 0; r < Rows; ++r) {
    for (std::size_t l = 0; l < number.size(); ++l) number[l] = static_cast<Real>(100 * l + r);
    x[r] = T::load_unaligned(number.data());
  }
  transpose(x);
  for (std::size_t n = 0; n < Rows * number.size(); ++n) // number r + Rows l is entry r of lane l
    EXPECT_EQ(lanes(x[n / number.size()])[n % number.size()], static_cast<Real>(100 * (n / Rows) + n % Rows));
}

TYPED_TEST(PackTest, RowsOfALaneLieSideBySideAfterTurning) {
  expect_turned<2, TypeParam>();
  expect_turned<4, TypeParam>();
  expect_turned<8, TypeParam>();
  expect_turned<16, TypeParam>();
}

TYPED_TEST(PackTest, SecondOfPairs) {
  const auto x = lanes(positions<TypeParam>()), y = lanes(second_of_pairs(positions<TypeParam>()));
  for (std::size_t l = 0; l < x.size(); ++l) EXPECT_EQ(y[l], l % 2 == 0 ? x[l + 1] : TypeParam(0));
}

TYPED_TEST(PackTest, NothingIsReadBeyondTheEnd) {
  using T = Pack<TypeParam>;
  const std::vector<TypeParam> one{3}; // under the address sanitizer a second read is an error
  for (const TypeParam x : lanes(load<T>(one.data(), 1))) EXPECT_EQ(x, 3);
}

} // namespace
} // namespace flipbook
