// SPDX-License-Identifier: MIT
// A [[particles]] entry of a scene: a file of particles (sim/files/README.md), its unit, and where it is put.
//
//   file      = "../data/drop.ply"    relative to the scene's file; else by its last part beside it or in
//   assets/particles unit, scale, rotate, translate    see read_placement.h; velocities are scaled and turned alike
//   velocity  = [1, 0]                instead of the file's, written as that of a body
#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/scene_files.h"

#include <optional>

namespace flipbook {

/// Nothing where a mistake was made.
[[nodiscard]] std::optional<ParticleSource> read_particle_source(const Node& table, SceneFiles& files,
                                                                 Mistakes& mistakes);

} // namespace flipbook
