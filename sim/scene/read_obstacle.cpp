// SPDX-License-Identifier: MIT
#include "sim/scene/read_obstacle.h"

#include "sim/scene/read_shape.h"

namespace flipbook {

std::optional<Obstacle> read_obstacle(const Node& table, SceneFiles& files, Mistakes& mistakes) {
  Obstacle obstacle;
  obstacle.shape = read_shape(table, {}, files, mistakes);
  if (!obstacle.shape) return std::nullopt;
  return obstacle;
}

} // namespace flipbook
