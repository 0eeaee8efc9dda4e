// SPDX-License-Identifier: MIT
// Maxima of numbers that are not negative, fast and the same for any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace flipbook {

/// A maximum for Pool::sum.
template <class Real> struct Largest {
  Real value = 0;
  void operator+=(const Largest& other) { value = std::max(value, other.value); }
};

/// The largest value(i) of [begin, end), or 0: maxima side by side, which a processor takes at once.
template <class Real, class Value> Largest<Real> largest(std::int64_t begin, std::int64_t end, Value&& value) {
  constexpr std::int64_t count = 8;
  std::array<Real, count> most{};
  std::int64_t i = begin;
  for (; i + count <= end; i += count)
    for (std::int64_t l = 0; l < count; ++l) {
      const Real x = value(static_cast<std::size_t>(i + l));
      Real& m = most[static_cast<std::size_t>(l)];
      m = m < x ? x : m;
    }
  for (; i < end; ++i) most[0] = std::max(most[0], value(static_cast<std::size_t>(i)));
  return {*std::max_element(most.begin(), most.end())};
}

} // namespace flipbook
