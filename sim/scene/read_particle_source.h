// SPDX-License-Identifier: MIT
// A [[particles]] entry of a scene: a file of particles, its unit, and where it is put.
#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/scene_files.h"

#include <optional>

namespace flipbook {

/// Nothing where a mistake was made.
[[nodiscard]] std::optional<ParticleSource> read_particle_source(const Node& table, SceneFiles& files,
                                                                 Mistakes& mistakes);

} // namespace flipbook
