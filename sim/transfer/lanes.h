// SPDX-License-Identifier: MIT
// The particles in the lanes of one pack, of which some may be skipped.
#pragma once

#include "sim/core/pack.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace flipbook {

/// Of particles from p on, `left` of them, as many as there are lanes. Those that are marked (one byte for each
/// particle; null: none) keep what they have.
template <class Real> class Lanes {
public:
  using T = Pack<Real>;
  static constexpr std::size_t count = lanes_of<T>;

  Lanes(std::size_t p, std::size_t left, const std::uint8_t* marks)
      : p_(p), many_(std::min(left, count)), marks_(marks ? marks + p : nullptr) {
    if (!marks) return;
    for (std::size_t l = 0; l < many_; ++l) skipped_ += marks_[l];
    if (skipped_ == 0) marks_ = nullptr;
  }

  [[nodiscard]] bool all_skipped() const { return skipped_ == many_; }
  /// All lanes are particles, and none of them is skipped.
  [[nodiscard]] bool whole() const { return many_ == count && !marks_; }

  [[nodiscard]] [[gnu::always_inline]] T read(const Real* column) const { return load<T>(column + p_, many_); }
  [[gnu::always_inline]] void write(const T& value, Real* column) const {
    if (whole())
      value.store_unaligned(column + p_);
    else
      write_some(value, column);
  }

  /// body(lane) for the lanes that are not skipped, in order.
  template <class Body> void each(Body&& body) const {
    for (std::size_t l = 0; l < many_; ++l)
      if (!marks_ || !marks_[l]) body(l);
  }
  /// body(particle) for the others.
  template <class Body> void each_skipped(Body&& body) const {
    if (!marks_) return;
    for (std::size_t l = 0; l < many_; ++l)
      if (marks_[l]) body(p_ + l);
  }

private:
  [[gnu::noinline, gnu::cold]] void write_some(const T& value, Real* column) const {
    std::array<Real, count> copy;
    value.store_unaligned(copy.data());
    each([&](std::size_t l) { column[p_ + l] = copy[l]; });
  }

  std::size_t p_, many_, skipped_ = 0;
  const std::uint8_t* marks_; ///< null: nobody is skipped
};

} // namespace flipbook
