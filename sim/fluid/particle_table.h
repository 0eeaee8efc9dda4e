// SPDX-License-Identifier: MIT
// The particles of a run as the table that files are written from.
#pragma once

#include "sim/core/particles.h"
#include "sim/files/particle_table.h"

namespace flipbook {

/// In the order of the ids; `origin` is added to the positions.
template <int Dim, class Real>
[[nodiscard]] ParticleTable particle_table(const Particles<Dim, Real>& particles, const std::array<double, 3>& origin,
                                           const std::vector<std::string>& carried = {});

} // namespace flipbook
