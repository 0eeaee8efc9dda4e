// SPDX-License-Identifier: MIT
#include "sim/scene/read_body.h"

#include "sim/scene/read_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook {
namespace {

VelocityPtr by_components(const Node& list, Mistakes& mistakes) {
  Point constant{0, 0, 0};
  std::array<std::optional<Expression>, 3> formula;
  if (list.items.size() < 2 || list.items.size() > 3) {
    mistakes.add("\"velocity\" must list 2 or 3 components, not " + std::to_string(list.items.size()), list.where);
    return nullptr;
  }
  for (std::size_t d = 0; d < list.items.size(); ++d) {
    const Node& n = list.items[d];
    if (n.type == Node::Type::number && std::isfinite(n.number))
      constant[d] = n.number;
    else if (n.type == Node::Type::text)
      formula[d] = Expression(n.text, {"x", "y", "z"}, n.where);
    else
      mistakes.add("a component of \"velocity\" must be a number or a formula in quotes, not " + to_toml(n), n.where);
  }
  return components_velocity(constant, std::move(formula));
}

/// { random = speed, size = metres, seed = n }
VelocityPtr by_chance(TableReader& reader) {
  const double speed = reader.number("random", 0, 1e6, std::nullopt);
  const double size = reader.number("size", 1e-6, 1e6, std::nullopt);
  const double seed = reader.number("seed", 0, 1e9, 1.0);
  return random_velocity(speed, size, static_cast<int>(seed));
}

/// { rotation = omega }, { strain = rate } or { swirl = "u_phi(r)" }, each with an optional centre.
VelocityPtr by_motion(const Node& table, Mistakes& mistakes) {
  TableReader reader(table, "a velocity", mistakes);
  static constexpr std::string_view kinds[] = {"rotation", "strain", "swirl", "random"};
  if (std::count_if(std::begin(kinds), std::end(kinds), [&](std::string_view k) { return table.find(k); }) != 1)
    mistakes.add("a velocity needs one of \"rotation\", \"strain\", \"swirl\", \"random\"", table.where);
  if (reader.optional("random")) {
    VelocityPtr velocity = by_chance(reader);
    reader.done();
    return velocity;
  }
  const std::vector<double> middle;
  const auto given = reader.numbers("centre", 2, 3, middle);
  Listed centre = listed(given);
  const auto rates = [&](std::string_view key, const Point& axes) -> Point {
    const Node* node = reader.optional(key);
    if (node->type != Node::Type::list) {
      const double one = reader.number(key, -1e6, 1e6, 0.0);
      return {one * axes[0], one * axes[1], one * axes[2]};
    }
    return listed(reader.numbers(key, 3, 3, std::nullopt)).x;
  };
  VelocityPtr velocity;
  if (reader.optional("rotation")) velocity = rotation_velocity(rates("rotation", {0, 0, 1}), centre);
  if (reader.optional("strain")) velocity = strain_velocity(rates("strain", {1, -1, 0}), centre);
  if (const Node* swirl = reader.optional("swirl")) {
    const std::string formula = reader.text("swirl", "");
    if (swirl->type == Node::Type::text) velocity = swirl_velocity(Expression(formula, {"r"}, swirl->where), centre);
  }
  reader.done();
  return velocity;
}

} // namespace

VelocityPtr read_velocity(const Node& node, Mistakes& mistakes) {
  try {
    if (node.type == Node::Type::list) return by_components(node, mistakes);
    if (node.type == Node::Type::table) return by_motion(node, mistakes);
    mistakes.add("\"velocity\" must be a list such as [1, \"sin(y)\"] or a table such as { rotation = 2 }, not " +
                     to_toml(node),
                 node.where);
  } catch (const UserError& error) {
    mistakes.add(error);
  }
  return nullptr;
}

namespace {

/// `material = { model = "sand", E = 1e6 }`: what is not said is as in the scene's own material of that model.
std::shared_ptr<const MaterialSettings> read_material(const Node& node, const Settings& settings, Mistakes& mistakes) {
  if (node.type != Node::Type::table) {
    mistakes.add("\"material\" of a body must be a table such as { model = \"snow\", E = 1e5 }, not " + to_toml(node),
                 node.where);
    return nullptr;
  }
  if (settings.solver != Solver::mpm) {
    mistakes.add("a body has a \"material\" with solver = \"mpm\" only", node.where);
    return nullptr;
  }
  auto material = std::make_shared<MaterialSettings>(settings.material);
  std::vector<Assignment> all;
  for (const Node& entry : node.items) flatten(entry, entry.key, all, mistakes);
  // The model first: it decides what the other names mean.
  std::stable_partition(all.begin(), all.end(), [](const Assignment& a) { return a.path == "model"; });
  for (const Assignment& a : all)
    if (const Refusal r = set_parameter(*material, a.path, a.value); !r.message.empty())
      mistakes.add(r.message, a.where, r.nearest);
  return material;
}

} // namespace

Body read_body(const Node& table, const Settings& settings, SceneFiles& files, Mistakes& mistakes) {
  Body body;
  static constexpr std::string_view own[] = {"velocity", "material"};
  body.shape = read_shape(table, own, files, mistakes);
  const Node* velocity = table.type == Node::Type::table ? table.find("velocity") : nullptr;
  if (const Node* material = table.type == Node::Type::table ? table.find("material") : nullptr)
    body.material = read_material(*material, settings, mistakes);
  body.velocity = velocity ? read_velocity(*velocity, mistakes) : components_velocity({0, 0, 0}, {});
  return body;
}

} // namespace flipbook
