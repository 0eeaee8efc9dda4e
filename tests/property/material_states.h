// SPDX-License-Identifier: MIT
// States that particles of any material may be in, for the tests of materials: deformations near and far, what is
// remembered, parameters.
#pragma once

#include "sim/core/random.h"
#include "sim/core/svd.h"
#include "sim/materials/materials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>

namespace flipbook::test {

/// A material in a dimension, and all of them.
template <class M_, int Dim_> struct MaterialCase {
  using M = M_;
  static constexpr int Dim = Dim_;
};
template <class List> struct MaterialCases;
template <class... M> struct MaterialCases<std::tuple<M...>> {
  using Type = testing::Types<MaterialCase<M, 2>..., MaterialCase<M, 3>...>;
};
struct MaterialCaseName {
  template <class C> static std::string GetName(int) { return std::string(C::M::name) + std::to_string(C::Dim) + "D"; }
};
inline double number(std::uint64_t seed, std::uint64_t n) {
  return 2 * uniform(19650611, seed, n) - 1;
}
template <int Dim> Square<Dim, double> random_rotation(std::uint64_t seed) {
  return polar(square<Dim, double>([&](std::size_t a, std::size_t b) { return number(seed, 3 * a + b); })).R;
}
/// A rotation, then stretches of up to e^far along random axes; the volume within e^-+volume.
template <int Dim> Square<Dim, double> deformed(std::uint64_t seed, double far, double volume) {
  std::array<double, Dim> eps;
  for (std::size_t d = 0; d < Dim; ++d) eps[d] = far * number(seed, 30 + d);
  const double mean = hencky::sum(eps) / Dim;
  for (double& each : eps) each = std::exp(each - mean + volume * number(seed, 40) / Dim);
  const auto U = random_rotation<Dim>(3 * seed), V = random_rotation<Dim>(3 * seed + 1);
  return times_transposed(U * diagonal<Dim, double>(eps), V);
}
struct Distance {
  double far, volume;
};
inline constexpr Distance distances[] = {{1e-3, 1e-3}, {0.1, 0.05}, {0.7, 0.5}, {1.2, 1}};
/// Those of them that a material needs to stand, and for some inverted ones.
template <class M, int Dim, class Body> void each_state(Body&& body) {
  for (const Distance& d : distances)
    for (std::uint64_t n = 0; n < 60; ++n) body(deformed<Dim>(n, d.far, d.volume), n);
  if (M::inverts)
    for (std::uint64_t n = 0; n < 60; ++n) {
      std::array<double, Dim> flip;
      flip.fill(1);
      flip[Dim - 1] = -0.5; // well away from where two singular values are opposite, and R is not unique
      body(times_transposed(random_rotation<Dim>(n) * diagonal<Dim, double>(flip), random_rotation<Dim>(n + 1000)), n);
    }
}

/// The material with parameters that matter all.
template <class M> M tried() {
  M m;
  if constexpr (requires { m.E; }) m.E = 2.5e4, m.nu = 0.35;
  if constexpr (requires { m.bulk_modulus; }) m.bulk_modulus = 3e4;
  if constexpr (requires { m.hardening_modulus; }) m.hardening_modulus = 4e3;
  return m;
}
/// What it may remember.
template <class M> Memory<double> remembered(const M& m, std::uint64_t n) {
  Memory<double> memory = m.memory();
  if constexpr (std::is_same_v<M, Snow>) memory[0] += 0.2 * number(n, 50);
  if constexpr (std::is_same_v<M, Sand>) memory = {uniform(7, n, 0), n % 2 == 0 ? 0.0 : 0.05 * uniform(7, n, 1)};
  if constexpr (std::is_same_v<M, VonMises>) memory[0] = uniform(7, n, 0);
  return memory;
}
template <class M> double stiffness(const M& m) {
  if constexpr (requires { m.mu(); })
    return m.lambda() + 2 * m.mu();
  else
    return m.bulk_modulus;
}

template <int Dim> double largest(const Square<Dim, double>& m) {
  double most = 0;
  for (const auto& row : m.rows)
    for (const double x : row)
      most = std::isnan(x) ? std::numeric_limits<double>::infinity() : std::max(most, std::abs(x));
  return most;
}
} // namespace flipbook::test
