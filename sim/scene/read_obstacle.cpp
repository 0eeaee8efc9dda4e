// SPDX-License-Identifier: MIT
#include "sim/scene/read_obstacle.h"

#include "sim/scene/read_motion.h"
#include "sim/scene/read_shape.h"

#include <algorithm>
#include <vector>

namespace flipbook {
namespace {

/// contact = "slip", "sticky" or "separating", the last one with an optional friction.
void read_contact(const Node& table, Obstacle& obstacle, Mistakes& mistakes) {
  static const std::vector<std::string> kinds{"slip", "sticky", "separating"};
  if (const Node* contact = table.find("contact")) {
    if (contact->type != Node::Type::text || std::find(kinds.begin(), kinds.end(), contact->text) == kinds.end())
      mistakes.add("\"contact\" must be \"slip\", \"sticky\" or \"separating\", not " + to_toml(*contact),
                   contact->where, nearest_name(contact->text, kinds));
    if (table.find("slip")) mistakes.add("an obstacle has \"slip\" or \"contact\", not both", contact->where);
    obstacle.no_slip = contact->text == "sticky";
    obstacle.separating = contact->text == "separating";
  }
  const Node* friction = table.find("friction");
  if (!friction) return;
  constexpr double most = 10;
  if (friction->type != Node::Type::number || !(friction->number >= 0 && friction->number <= most))
    mistakes.add("\"friction\" must be a number between 0 and 10, not " + to_toml(*friction), friction->where);
  else if (!obstacle.separating)
    mistakes.add("\"friction\" is for an obstacle with contact = \"separating\"", friction->where);
  obstacle.friction = friction->number;
}

} // namespace

std::optional<Obstacle> read_obstacle(const Node& table, const Domain& domain, SceneFiles& files, Mistakes& mistakes) {
  static constexpr std::string_view own[] = {"slip", "contact", "friction", "motion"};
  Obstacle obstacle;
  obstacle.shape = read_shape(table, own, files, mistakes);
  if (const Node* slip = table.type == Node::Type::table ? table.find("slip") : nullptr) {
    if (slip->type != Node::Type::flag)
      mistakes.add("\"slip\" must be true or false, not " + to_toml(*slip), slip->where);
    obstacle.no_slip = !slip->flag;
  }
  if (table.type == Node::Type::table) read_contact(table, obstacle, mistakes);
  if (const Node* motion = table.type == Node::Type::table ? table.find("motion") : nullptr)
    obstacle.motion = read_motion(*motion, domain, mistakes);
  if (!obstacle.shape) return std::nullopt;
  return obstacle;
}

} // namespace flipbook
