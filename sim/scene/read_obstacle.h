// SPDX-License-Identifier: MIT
// An [[obstacle]] of a scene: a shape by name, its motion, and whether the fluid slips along it.
#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/scene_files.h"

#include <optional>

namespace flipbook {

/// Nothing where a mistake was made.
[[nodiscard]] std::optional<Obstacle> read_obstacle(const Node& table, SceneFiles& files, Mistakes& mistakes);

} // namespace flipbook
