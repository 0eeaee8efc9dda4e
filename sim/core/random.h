// SPDX-License-Identifier: MIT
// Random numbers without a state: a hash of counters, so that any of them can be had in any order and on any thread.
// The mixing function is the output function of SplitMix64 [Steele, Lea, Flood 2014].
#pragma once

#include <cstdint>

namespace flipbook {

[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

/// Uniform in (0, 1), the ends excluded: a function of the seed and two counters.
[[nodiscard]] constexpr double uniform(std::uint64_t seed, std::uint64_t a, std::uint64_t b) {
  const std::uint64_t bits = mix(mix(mix(seed) + a) + b);
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52;
}

} // namespace flipbook
