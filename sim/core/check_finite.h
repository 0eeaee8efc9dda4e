// SPDX-License-Identifier: MIT
// Whether a step went well: a particle that stopped being finite ends the run.
#pragma once

#include "sim/core/parallel.h"
#include "sim/core/particles.h"
#include "sim/frame/errors.h"

#include <optional>

namespace flipbook {

/// The id of the first particle in their order of which any column is not finite.
template <int Dim, class Real>
[[nodiscard]] std::optional<std::uint32_t> first_non_finite(const Particles<Dim, Real>& particles, Pool& pool);

/// Throws a NonFiniteError for that particle. `title()` names the scheme.
template <int Dim, class Real, class Title>
void check_finite(const Particles<Dim, Real>& particles, Title&& title, std::uint64_t step, double time, Pool& pool) {
  if (const auto id = first_non_finite(particles, pool)) throw NonFiniteError(title(), step, time, *id);
}

} // namespace flipbook
