// SPDX-License-Identifier: MIT
// Zeros on every sample, by all threads.
#pragma once

#include "sim/core/field.h"
#include "sim/core/parallel.h"

#include <algorithm>
#include <cstdint>

namespace flipbook {

template <int Dim, class Real> void clear(Components<Dim, Real>& field, Pool& pool) {
  constexpr std::int64_t samples_per_chunk = 1 << 15;
  for (auto& f : field)
    pool.ranges(static_cast<std::int64_t>(f.size()), samples_per_chunk,
                [&](std::int64_t begin, std::int64_t end) { std::fill(f.begin() + begin, f.begin() + end, Real(0)); });
}

} // namespace flipbook
