// SPDX-License-Identifier: MIT
#include "sim/scene/read_obstacle.h"

#include "sim/scene/read_motion.h"
#include "sim/scene/read_shape.h"

namespace flipbook {

std::optional<Obstacle> read_obstacle(const Node& table, const Domain& domain, SceneFiles& files, Mistakes& mistakes) {
  static constexpr std::string_view own[] = {"slip", "motion"};
  Obstacle obstacle;
  obstacle.shape = read_shape(table, own, files, mistakes);
  if (const Node* slip = table.type == Node::Type::table ? table.find("slip") : nullptr) {
    if (slip->type != Node::Type::flag)
      mistakes.add("\"slip\" must be true or false, not " + to_toml(*slip), slip->where);
    obstacle.no_slip = !slip->flag;
  }
  if (const Node* motion = table.type == Node::Type::table ? table.find("motion") : nullptr)
    obstacle.motion = read_motion(*motion, domain, mistakes);
  if (!obstacle.shape) return std::nullopt;
  return obstacle;
}

} // namespace flipbook
