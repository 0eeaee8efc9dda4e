// SPDX-License-Identifier: MIT
// Every material of the list against its own energy: stress, moduli, plastic flow, the speed of waves; and that packs
// hold what numbers give.
#include "sim/core/pack.h"
#include "tests/property/material_states.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace flipbook::test {
namespace {

template <class C> class MaterialTest : public testing::Test {};
TYPED_TEST_SUITE(MaterialTest, MaterialCases<Materials>::Type, MaterialCaseName);

/// I + h m n^T
template <int Dim>
Square<Dim, double> nudge(double h, const std::array<double, Dim>& m, const std::array<double, Dim>& n) {
  return square<Dim, double>([&](std::size_t a, std::size_t b) { return (a == b ? 1 : 0) + h * m[a] * n[b]; });
}
template <int Dim> std::array<double, Dim> axis(std::size_t a) {
  std::array<double, Dim> e{};
  e[a] = 1;
  return e;
}
template <int Dim> std::array<double, Dim> direction(std::uint64_t seed, std::uint64_t from) {
  std::array<double, Dim> e;
  for (std::size_t d = 0; d < Dim; ++d) e[d] = number(seed, from + d);
  const double length = hencky::length(e);
  for (double& each : e) each /= length;
  return e;
}
/// dy/dh at 0, to fourth order in h.
template <class Y> double slope(Y&& y, double h) {
  return (8 * (y(h) - y(-h)) - (y(2 * h) - y(-2 * h))) / (12 * h);
}
/// d2y/dh2 at 0, to fourth order in h.
template <class Y> double curvature(Y&& y, double h) {
  return (16 * (y(h) + y(-h)) - (y(2 * h) + y(-2 * h)) - 30 * y(0)) / (12 * h * h);
}

// === Energy and stress

TYPED_TEST(MaterialTest, StressIsTheSlopeOfTheEnergy) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  each_state<typename TypeParam::M, Dim>([&](const Square<Dim, double>& F, std::uint64_t n) {
    const auto memory = remembered(m, n);
    const auto tau = m.kirchhoff(F, memory);
    const double within = 1e-9 * std::max(m.wave_modulus(F, memory), largest(tau));
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t b = 0; b < Dim; ++b) { // dPsi/dh of (I + h e_a e_b^T) F is (P F^T)_ab
        const auto energy = [&](double h) { return m.energy(nudge<Dim>(h, axis<Dim>(a), axis<Dim>(b)) * F, memory); };
        ASSERT_NEAR(tau[a][b], slope(energy, 5e-4), within) << n;
      }
  });
}

TYPED_TEST(MaterialTest, StressIsSymmetric) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  each_state<typename TypeParam::M, Dim>([&](const Square<Dim, double>& F, std::uint64_t n) {
    const auto memory = remembered(m, n);
    const auto tau = m.kirchhoff(F, memory);
    ASSERT_LE(largest(tau - transposed(tau)), 1e-12 * m.wave_modulus(F, memory));
  });
}

/// Nothing changes for an observer who turns, nor in a body that was turned before it was deformed.
TYPED_TEST(MaterialTest, TurningChangesNothing) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  each_state<typename TypeParam::M, Dim>([&](const Square<Dim, double>& F, std::uint64_t n) {
    const auto memory = remembered(m, n);
    const auto R = random_rotation<Dim>(n + 5000);
    const double psi = m.energy(F, memory), scale = m.wave_modulus(F, memory), within = 1e-12 * scale;
    const auto tau = m.kirchhoff(F, memory);
    ASSERT_NEAR(m.energy(R * F, memory), psi, within);
    ASSERT_NEAR(m.energy(F * R, memory), psi, within);
    ASSERT_NEAR(m.wave_modulus(F * R, memory), scale, within);
    ASSERT_LE(largest(m.kirchhoff(R * F, memory) - times_transposed(R * tau, R)), within);
    ASSERT_LE(largest(m.kirchhoff(F * R, memory) - tau), within);
  });
}

TYPED_TEST(MaterialTest, AtRestThereIsNoStressAndNoEnergy) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  for (std::uint64_t n = 0; n < 50; ++n) {
    const auto R = n == 0 ? identity<Dim, double>() : random_rotation<Dim>(n);
    EXPECT_NEAR(m.energy(R, m.memory()), 0, 1e-15 * stiffness(m));
    EXPECT_LE(largest(m.kirchhoff(R, m.memory())), 1e-14 * stiffness(m));
    EXPECT_NEAR(m.wave_modulus(R, m.memory()), stiffness(m), 1e-9 * stiffness(m)) << "steps would be too short";
  }
}

TYPED_TEST(MaterialTest, SmallStrainsMeetTheModuliOfLame) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  double mu = 0, lambda = 0;
  if constexpr (requires { m.mu(); }) {
    mu = m.mu(), lambda = m.lambda();
    EXPECT_NEAR(mu * (3 * lambda + 2 * mu) / (lambda + mu), m.E, 1e-9 * m.E);
    EXPECT_NEAR(lambda / (2 * (lambda + mu)), m.nu, 1e-12);
  } else {
    lambda = m.bulk_modulus;
  }
  const auto modulus = [&](std::size_t a, std::size_t b, std::size_t i, std::size_t j) { // dtau_ij / dF_ab
    const auto tau = [&](double h) { return m.kirchhoff(nudge<Dim>(h, axis<Dim>(a), axis<Dim>(b)), m.memory())[i][j]; };
    return slope(tau, 1e-3);
  };
  const double within = 1e-8 * stiffness(m);
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t b = 0; b < Dim; ++b) {
      EXPECT_NEAR(modulus(a, a, b, b), a == b ? lambda + 2 * mu : lambda, within) << a << b;
      if (a != b) {
        EXPECT_NEAR(modulus(a, b, a, b), mu, within) << a << b;
        EXPECT_NEAR(modulus(a, a, a, b), 0, within) << a << b;
      }
    }
}

/// rho_0 c^2 of a plane wave along n that swings along m: d2Psi/dh2 of (I + h m n^T) F.
TYPED_TEST(MaterialTest, NoWaveIsFasterThanSaid) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  each_state<typename TypeParam::M, Dim>([&](const Square<Dim, double>& F, std::uint64_t n) {
    const auto memory = remembered(m, n);
    const double said = m.wave_modulus(F, memory);
    double fastest = 0;
    const auto U = svd(F).U;
    for (std::uint64_t k = 0; k < 40; ++k) {
      auto along = direction<Dim>(n, 100 + 6 * k), swings = k % 2 == 0 ? along : direction<Dim>(n, 103 + 6 * k);
      if (k < Dim * Dim) { // along the axes of the stretch, where extremes lie
        for (std::size_t d = 0; d < Dim; ++d) along[d] = U[d][k / Dim], swings[d] = U[d][k % Dim];
      }
      const auto energy = [&](double h) { return m.energy(nudge<Dim>(h, swings, along) * F, memory); };
      fastest = std::max(fastest, curvature(energy, 1e-3));
    }
    ASSERT_GE(said, fastest * (1 - 1e-7)) << n << ' ' << said / fastest;
  });
}

// === All at once

/// What the sweep over the particles asks for is what the separate answers are.
TYPED_TEST(MaterialTest, AnswersTheSameAllAtOnce) {
  constexpr int Dim = TypeParam::Dim;
  const auto m = tried<typename TypeParam::M>();
  each_state<typename TypeParam::M, Dim>([&](const Square<Dim, double>& F, std::uint64_t n) {
    const auto before = remembered(m, n);
    auto flown = F, other = F;
    auto memory = before, other_memory = before;
    const auto all = response_of(m, flown, memory);
    m.flow(other, other_memory);
    const double within = 1e-12 * m.wave_modulus(F, before);
    ASSERT_LE(largest(flown - other), 1e-14) << n;
    for (std::size_t c = 0; c < most_memory; ++c) ASSERT_NEAR(memory[c], other_memory[c], 1e-14) << n;
    ASSERT_NEAR(all.before_flow, m.energy(F, before), within) << n;
    ASSERT_NEAR(all.energy, m.energy(flown, memory), within) << n;
    ASSERT_LE(largest(all.tau - m.kirchhoff(flown, memory)), within) << n;
    ASSERT_NEAR(all.wave_modulus, m.wave_modulus(flown, memory), within) << n;
  });
}

// === Packs

template <class Real> Real lane(const Pack<Real>& x, std::size_t l) {
  std::array<Real, lanes_of<Pack<Real>>> all;
  x.store_unaligned(all.data());
  return all[l];
}

/// Of some particles at once and one by one.
template <class M, int Dim, class Real> void expect_lanes(const M& m, double within) {
  using T = Pack<Real>;
  std::vector<Square<Dim, double>> F;
  each_state<M, Dim>([&](const Square<Dim, double>& some, std::uint64_t) { F.push_back(some); });
  for (std::size_t first = 0; first + lanes_of<T> <= F.size(); first += 3) { // lanes of two kinds side by side
    std::array<Real, lanes_of<T>> some;
    const auto pack = [&](auto&& of_lane) {
      for (std::size_t l = 0; l < some.size(); ++l) some[l] = static_cast<Real>(of_lane(l));
      return T::load_unaligned(some.data());
    };
    const auto stride = F.size() / lanes_of<T>;
    const auto at = [&](std::size_t l) { return (first + l * stride) % F.size(); };
    auto packs = square<Dim, T>(
        [&](std::size_t a, std::size_t b) { return pack([&](std::size_t l) { return F[at(l)][a][b]; }); });
    Memory<T> memory;
    for (std::size_t c = 0; c < most_memory; ++c)
      memory[c] = pack([&](std::size_t l) { return remembered(m, at(l))[c]; });
    const T energy = m.energy(packs, memory), modulus = m.wave_modulus(packs, memory);
    const auto tau = m.kirchhoff(packs, memory);
    auto flown = packs;
    auto flown_memory = memory;
    m.flow(flown, flown_memory);
    for (std::size_t l = 0; l < lanes_of<T>; ++l) {
      auto own = square<Dim, Real>([&](std::size_t a, std::size_t b) { return lane<Real>(packs[a][b], l); });
      Memory<Real> own_memory{lane<Real>(memory[0], l), lane<Real>(memory[1], l)};
      const Real scale = m.wave_modulus(own, own_memory), most = static_cast<Real>(within) * scale;
      ASSERT_NEAR(lane<Real>(modulus, l), scale, most);
      ASSERT_NEAR(lane<Real>(energy, l), m.energy(own, own_memory), most);
      const auto own_tau = m.kirchhoff(own, own_memory);
      m.flow(own, own_memory);
      for (std::size_t a = 0; a < Dim; ++a)
        for (std::size_t b = 0; b < Dim; ++b) {
          ASSERT_NEAR(lane<Real>(tau[a][b], l), own_tau[a][b], most);
          ASSERT_NEAR(lane<Real>(flown[a][b], l), own[a][b], 10 * within);
        }
      for (std::size_t c = 0; c < most_memory; ++c)
        ASSERT_NEAR(lane<Real>(flown_memory[c], l), own_memory[c], 10 * within);
    }
  }
}

TYPED_TEST(MaterialTest, LanesAreWhatNumbersGive) {
  const auto m = tried<typename TypeParam::M>();
  expect_lanes<typename TypeParam::M, TypeParam::Dim, double>(m, 1e-13);
  expect_lanes<typename TypeParam::M, TypeParam::Dim, float>(m, 5e-5);
}

} // namespace
} // namespace flipbook::test
