// SPDX-License-Identifier: MIT
// The particles of one file, fit to be drawn.
#pragma once

#include "sim/files/particle_rows.h"

#include <string>

namespace flipbook::app {

/// Throws UserError for a file that read_particles() refuses, and for positions beyond 1e9 m or velocities beyond
/// 1e9 m/s: pictures are computed with 32-bit numbers, which must not overflow.
[[nodiscard]] ParticleRows read_drawable(const std::string& file, bool ids);

} // namespace flipbook::app
