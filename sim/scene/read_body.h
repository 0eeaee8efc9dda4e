// SPDX-License-Identifier: MIT
// A [[body]] of a scene: a shape by name, the velocity that what is inside starts with, and what it is made of.
#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/scene_files.h"

namespace flipbook {

/// The shape is null where a mistake was made. `settings`: those of the scene, where its own material is.
[[nodiscard]] Body read_body(const Node& table, const Settings& settings, SceneFiles& files, Mistakes& mistakes);

/// `velocity = [1, "sin(y)"]` or `velocity = { rotation = 2 }`; null where a mistake was made.
[[nodiscard]] VelocityPtr read_velocity(const Node& node, Mistakes& mistakes);

} // namespace flipbook
