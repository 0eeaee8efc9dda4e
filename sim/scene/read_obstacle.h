// SPDX-License-Identifier: MIT
// An [[obstacle]] of a scene: a shape by name, whether the fluid slips along it, and its motion.
#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/scene_files.h"

#include <optional>

namespace flipbook {

/// Nothing where a mistake was made. `domain`: of the scene.
[[nodiscard]] std::optional<Obstacle> read_obstacle(const Node& table, const Domain& domain, SceneFiles& files,
                                                    Mistakes& mistakes);

} // namespace flipbook
