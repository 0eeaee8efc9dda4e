// SPDX-License-Identifier: MIT
// WRONG ON PURPOSE: what the bug museum shows. See mistakes.cpp.
#pragma once

#include "sim/fluid/stage_hook.h"
#include "sim/museum/museum.h"

#include <memory>

namespace flipbook::museum {

/// The hook that commits the mistake in a solver's steps, of length `dt` (s; the solver's owner keeps it up to date).
template <int Dim, class Real>
[[nodiscard]] std::unique_ptr<StageHook<Dim, Real>> make_mistake(std::size_t exhibit, const double& dt, Pool& pool);

} // namespace flipbook::museum
