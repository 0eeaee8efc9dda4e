// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/transfer/interpolate.h"

namespace flipbook {
namespace {

template <class K> class KernelTest : public testing::Test {};
using AllKernels = testing::Types<Linear, Quadratic, Cubic>;
TYPED_TEST_SUITE(KernelTest, AllKernels);

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
    const int base = K::base(q);
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
      const int base = K::base(at);
      for (std::size_t i = 0; i < K::support; ++i) n[static_cast<std::size_t>(base) + i] = K::weights(at - base)[i];
    };
    fill(q - 1e-12, below);
    fill(q + 1e-12, above);
    for (std::size_t i = 0; i < below.size(); ++i) EXPECT_NEAR(below[i], above[i], 1e-11);
  }
}

TEST(Kernels, ListAndNamesAgree) {
  for (const KernelName k : kernels)
    with_kernel(k, [&](auto kernel) { EXPECT_EQ(kernel.name, kernel_options()[static_cast<std::size_t>(k)].name); });
  EXPECT_EQ(kernel_options()[1].name, "quadratic");
}

template <class C> class InterpolatorTest : public testing::Test {};
TYPED_TEST_SUITE(InterpolatorTest, Cases);

TYPED_TEST(InterpolatorTest, ReproducesAnAffineFieldAndItsGradient) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  Threads threads(1);
  const Trial<Dim, Real> trial(AffineMode::none, 60, 3, threads.pool);
  each_combination({pic}, [&](const Corner&, KernelName kernel, Layout layout) {
    const auto field = trial.affine_field(layout, false);
    with_kernel(kernel, [&](auto k) {
      const Interpolator<decltype(k), Dim, Real> velocity(layout, trial.grid, field);
      const Vec<Dim, Real> centre = trial.origin.template cast<Real>();
      const Mat<Dim, Real> C = velocity.gradient(centre);
      EXPECT_GT(C.norm(), 1);
      for (std::size_t p = 0; p < trial.particles.size(); ++p) {
        const Vec<Dim, Real> x = trial.particles.position(p);
        const Vec<Dim, Real> expected = velocity(centre) + C * (x - centre);
        EXPECT_LT((velocity(x) - expected).norm(), 3 * TypeParam::tolerance);
        EXPECT_LT((velocity.gradient(x) - C).norm(), 3 * TypeParam::tolerance / trial.grid.dx);
      }
      // A known value: the field at the centre is the constant of affine_field.
      for (int a = 0; a < Dim; ++a)
        EXPECT_NEAR(velocity(centre)[a], trial.number(6, static_cast<std::uint64_t>(a), 0, -1, 1),
                    TypeParam::tolerance);
    });
  });
}

} // namespace
} // namespace flipbook
