// SPDX-License-Identifier: MIT
#include "sim/core/check_finite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flipbook {
namespace {

template <class Real> bool all_finite(const Real* begin, const Real* end) {
  constexpr std::ptrdiff_t count = 8;
  std::array<Real, count> zero{}; // stay zero unless something is not finite
  for (; end - begin >= count; begin += count)
    for (std::ptrdiff_t l = 0; l < count; ++l) zero[static_cast<std::size_t>(l)] += 0 * begin[l];
  for (; begin < end; ++begin) zero[0] += 0 * *begin;
  return std::all_of(zero.begin(), zero.end(), [](Real z) { return z == 0; });
}

/// The smallest of some places, for Pool::sum.
struct First {
  std::size_t at = std::numeric_limits<std::size_t>::max();
  void operator+=(const First& other) { at = std::min(at, other.at); }
};

} // namespace

template <int Dim, class Real>
std::optional<std::uint32_t> first_non_finite(const Particles<Dim, Real>& particles, Pool& pool) {
  constexpr std::int64_t grain = 8192;
  const auto look_at = [&](std::int64_t begin, std::int64_t end) {
    First first;
    const auto look = [&](const std::vector<Real>& column) {
      if (all_finite(column.data() + begin, column.data() + end)) return;
      const auto bad = std::find_if(column.begin() + begin, column.end(), [](Real x) { return !std::isfinite(x); });
      first += {static_cast<std::size_t>(bad - column.begin())};
    };
    for (std::size_t d = 0; d < Dim; ++d) look(particles.x[d]), look(particles.v[d]);
    for (const auto& column : particles.A) look(column);
    for (const auto& column : particles.carried) look(column);
    return first;
  };
  const First first = pool.sum(static_cast<std::int64_t>(particles.size()), grain, First{}, look_at);
  if (first.at >= particles.size()) return std::nullopt;
  return particles.id[first.at];
}

template std::optional<std::uint32_t> first_non_finite(const Particles<2, float>&, Pool&);
template std::optional<std::uint32_t> first_non_finite(const Particles<2, double>&, Pool&);
template std::optional<std::uint32_t> first_non_finite(const Particles<3, float>&, Pool&);
template std::optional<std::uint32_t> first_non_finite(const Particles<3, double>&, Pool&);

} // namespace flipbook
