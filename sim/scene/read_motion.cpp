// SPDX-License-Identifier: MIT
#include "sim/scene/read_motion.h"

#include "sim/scene/expression.h"
#include "sim/scene/read_shape.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace flipbook {
namespace {

constexpr double farthest = 1e6; // metres, radians, seconds

/// A number, or a formula in t.
struct OfTime {
  double constant = 0;
  std::optional<Expression> formula{};

  [[nodiscard]] double operator()(double t) const {
    return formula ? (*formula)(std::span<const double>(&t, 1)) : constant;
  }
};

OfTime read_of_time(const Node& node, const std::string& what, Mistakes& mistakes) {
  OfTime f;
  if (node.type == Node::Type::text) {
    f.formula = Expression(node.text, {"t"}, node.where);
    (void)f(0); // not finite where the motion starts: said now
  } else if (node.type == Node::Type::number && std::abs(node.number) <= farthest) {
    f.constant = node.number;
  } else {
    mistakes.add(what + " must be a number or a formula in t in quotes, not " + to_toml(node), node.where);
  }
  return f;
}

std::array<OfTime, 3> read_offset(const Node* list, Mistakes& mistakes) {
  std::array<OfTime, 3> offset;
  if (!list) return offset;
  if (list->type != Node::Type::list || list->items.size() < 2 || list->items.size() > 3) {
    mistakes.add("\"offset\" must list 2 or 3 numbers or formulas in t, not " + to_toml(*list), list->where);
    return offset;
  }
  for (std::size_t d = 0; d < list->items.size(); ++d)
    offset[d] = read_of_time(list->items[d], "a component of \"offset\"", mistakes);
  return offset;
}

// === Keys

enum class Ease { smooth, linear };

struct MotionKey {
  double t = 0;
  Displacement to;
  Ease ease = Ease::smooth; ///< on the way here from the key before
};

Ease read_ease(TableReader& table) {
  const std::string name = table.text("ease", "smooth");
  if (name == "smooth") return Ease::smooth;
  if (name == "linear") return Ease::linear;
  const Node& ease = *table.optional("ease");
  if (name == "step") { // which studies have
    table.mistake("an obstacle cannot jump through the fluid: here \"ease\" is \"smooth\" or \"linear\"", ease);
    return Ease::smooth;
  }
  const std::vector<std::string> all{"smooth", "linear"};
  table.mistake("there is no ease \"" + name + "\" of a motion: it is \"smooth\" or \"linear\"", ease,
                nearest_name(name, all));
  return Ease::smooth;
}

MotionKey read_key(const Node& node, double after, Mistakes& mistakes) {
  MotionKey key;
  TableReader table(node, "a key of a motion", mistakes);
  key.t = table.number("t", -farthest, farthest, std::nullopt);
  const Node* t = table.optional("t");
  if (t && key.t <= after) table.mistake("the keys of a motion must be in the order of their times", *t);
  key.to.offset = listed(table.numbers("offset", 2, 3, std::vector<double>{0, 0})).x;
  key.to.angle = table.number("angle", -farthest, farthest, 0.0);
  key.ease = read_ease(table);
  table.done();
  return key;
}

std::vector<MotionKey> read_keys(const Node& list, Mistakes& mistakes) {
  std::vector<MotionKey> keys;
  if (list.type != Node::Type::list || list.items.empty()) {
    mistakes.add("\"keys\" must be a list such as [{ t = 0 }, { t = 1, offset = [0.3, 0] }]", list.where);
    return keys;
  }
  for (const Node& node : list.items) {
    if (node.type == Node::Type::table)
      keys.push_back(read_key(node, keys.empty() ? -2 * farthest : keys.back().t, mistakes));
    else
      mistakes.add("a key of a motion is a table such as { t = 1, offset = [0.3, 0] }, not " + to_toml(node),
                   node.where);
  }
  return keys;
}

/// At the first key before it, at the last one after it.
Displacement between(const std::vector<MotionKey>& keys, double t) {
  if (keys.empty()) return {}; // a mistake is on record
  const auto next = std::find_if(keys.begin(), keys.end(), [t](const MotionKey& k) { return k.t > t; });
  if (next == keys.begin()) return keys.front().to;
  const MotionKey& from = *(next - 1);
  if (next == keys.end()) return from.to;
  double s = (t - from.t) / (next->t - from.t);
  if (next->ease == Ease::smooth) s = s * s * (3 - 2 * s);
  Displacement now;
  for (std::size_t d = 0; d < 3; ++d) now.offset[d] = (1 - s) * from.to.offset[d] + s * next->to.offset[d];
  now.angle = (1 - s) * from.to.angle + s * next->to.angle;
  return now;
}

std::function<Displacement(double)> read_displacement(TableReader& table, Mistakes& mistakes) {
  const Node *offset = table.optional("offset"), *angle = table.optional("angle");
  if (const Node* keys = table.optional("keys")) {
    if (offset || angle) table.mistake("with \"keys\" the \"offset\" and the \"angle\" belong to each key", *keys);
    return [all = read_keys(*keys, mistakes)](double t) { return between(all, t); };
  }
  return [along = read_offset(offset, mistakes),
          turned = angle ? read_of_time(*angle, "\"angle\"", mistakes) : OfTime{}](double t) {
    return Displacement{{along[0](t), along[1](t), along[2](t)}, turned(t)};
  };
}

} // namespace

MotionPtr read_motion(const Node& node, const Domain& domain, Mistakes& mistakes) {
  if (node.type != Node::Type::table) {
    mistakes.add("\"motion\" must be a table such as { offset = [\"0.2*sin(2*pi*t)\", 0] }, not " + to_toml(node),
                 node.where);
    return nullptr;
  }
  TableReader table(node, "a motion", mistakes);
  const std::vector<double> upwards{0, 0, 1};
  const Point axis = listed(table.numbers("axis", 3, 3, upwards)).x;
  if (axis == Point{0, 0, 0}) table.mistake("\"axis\" must not be zero", *table.optional("axis"));
  const std::vector<double> middle;
  const Point centre = listed(table.numbers("centre", 2, 3, middle)).in(domain);
  MotionPtr motion;
  try {
    motion = make_motion(read_displacement(table, mistakes), domain.dim == 2 ? Point{0, 0, 1} : axis, centre);
  } catch (const UserError& error) {
    mistakes.add(error);
  }
  table.done();
  return motion;
}

} // namespace flipbook
