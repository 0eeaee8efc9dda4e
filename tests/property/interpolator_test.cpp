// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/transfer/interpolate.h"

namespace flipbook {
namespace {

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
