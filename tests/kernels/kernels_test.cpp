// SPDX-License-Identifier: MIT
// What every kernel promises, from its header alone.
#include "sim/kernels/kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <tuple>

namespace flipbook {
namespace {

template <class List> struct AllOf;
template <class... K> struct AllOf<std::tuple<K...>> { using Types = testing::Types<K...>; };
template <class K> class KernelTest : public testing::Test {};
TYPED_TEST_SUITE(KernelTest, AllOf<Kernels>::Types);

/// body(q) for positions all over a cell.
template <class Body> void each_position(Body&& body) {
  for (int i = 0; i < 499; ++i) body(5 + 0.002 * i + 0.001);
}

TYPED_TEST(KernelTest, WeightsAreAPartitionOfUnityCentredOnTheParticle) {
  using K = TypeParam;
  each_position([](double q) {
    const double f = q - K::base(q);
    double sum = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < K::support; ++i) {
      const double w = K::weights(f)[i], t = static_cast<double>(i) - f;
      EXPECT_GE(w, 0);
      sum += w;
      first += w * t;
      second += w * t * t;
    }
    EXPECT_NEAR(sum, 1, 4e-16);
    EXPECT_NEAR(first, 0, 4e-16);
    EXPECT_NEAR(second, K::second_moment(f), 4e-16);
  });
}

TYPED_TEST(KernelTest, SlopesAreTheDerivativeOfTheWeights) {
  using K = TypeParam;
  const double h = 1e-4; // of a piecewise cubic: an error of h^2/6 times its third derivative, at most 3
  each_position([&](double q) {
    const double base = K::base(q);
    for (std::size_t i = 0; i < K::support; ++i) {
      const double f = q - base;
      const double difference = (K::weights(f + h)[i] - K::weights(f - h)[i]) / (2 * h);
      EXPECT_NEAR(K::slopes(f)[i], difference, 6e-9);
    }
  });
}

TYPED_TEST(KernelTest, AffineWeightsAreTheMomentsDividedByD) {
  using K = TypeParam;
  each_position([](double q) {
    const double f = q - K::base(q);
    for (std::size_t i = 0; i < K::support; ++i) {
      const double moment = K::weights(f)[i] * (static_cast<double>(i) - f);
      EXPECT_NEAR(K::moment(f)[i], moment, 2e-16);
      EXPECT_NEAR(K::affine(f)[i] * K::second_moment(f), moment, 4e-16);
    }
  });
}

TYPED_TEST(KernelTest, WeightsAreContinuousFromCellToCell) {
  using K = TypeParam;
  for (const double q : {5.0, 5.5, 6.0}) { // where one kernel or another changes its first sample
    std::array<double, 12> below{}, above{};
    const auto fill = [](double at, std::array<double, 12>& n) {
      const double base = K::base(at);
      for (std::size_t i = 0; i < K::support; ++i) n[static_cast<std::size_t>(base) + i] = K::weights(at - base)[i];
    };
    fill(q - 1e-12, below);
    fill(q + 1e-12, above);
    for (std::size_t i = 0; i < below.size(); ++i) EXPECT_NEAR(below[i], above[i], 1e-11);
  }
}

TEST(Kernels, ListAndNamesAgree) {
  ASSERT_EQ(kernel_options().size(), std::tuple_size_v<Kernels>);
  for (std::size_t k = 0; k < kernel_options().size(); ++k)
    with_kernel(static_cast<KernelName>(k), [&](auto kernel) { EXPECT_EQ(kernel.name, kernel_options()[k].name); });
  EXPECT_EQ(kernel_options()[1].name, "quadratic");
}

} // namespace
} // namespace flipbook
