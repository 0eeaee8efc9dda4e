// SPDX-License-Identifier: MIT
// Measures one claim on one random state.
#pragma once

#include "sim/core/parallel.h"
#include "sim/diagnostics/claims.h"

#include <cstdint>

namespace flipbook {

/// The relative error. Of a kinetic energy its relative change, below 0 where it falls.
template <int Dim, class Real>
[[nodiscard]] double measure(const Claim& claim, KernelName kernel, Layout layout, std::uint64_t seed, Pool& pool);

/// The same for a claim about many cycles (Check::cycles, Check::carried_gradient).
template <int Dim, class Real>
[[nodiscard]] double measure_cycles(const Claim& claim, KernelName kernel, Layout layout, std::uint64_t seed,
                                    Pool& pool);

} // namespace flipbook
