// SPDX-License-Identifier: MIT
#include "app/study/edits.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace flipbook::app {
namespace {

constexpr double latest = 1e6, farthest = 1e6, fastest = 1e9; // seconds, metres, m/s
constexpr int most_panes = 12, most_solids = 65535;

const std::vector<std::string> hands{"push", "add", "remove", "move"};

Triple triple(const std::vector<double>& numbers) {
  Triple t{0, 0, 0};
  std::copy_n(numbers.begin(), std::min<std::size_t>(numbers.size(), 3), t.begin());
  return t;
}

/// The entries of one hand's table.
class Hand {
public:
  Hand(const Node& node, Mistakes& mistakes) : table_(node, "\"" + node.key + "\"", mistakes) {}
  ~Hand() { table_.done(); }

  Triple place(const char* key, double most, std::optional<std::vector<double>> fallback = {}) {
    Triple t = triple(table_.numbers(key, 2, 3, std::move(fallback)));
    for (double& x : t) x = std::clamp(x, -most, most);
    return t;
  }
  double radius() { return table_.number("radius", 0, farthest, std::nullopt); }
  double over() { return table_.number("over", 1e-9, latest, std::nullopt); }
  std::uint32_t solid() { return static_cast<std::uint32_t>(table_.number("solid", 1, most_solids, std::nullopt)) - 1; }

private:
  TableReader table_;
};

Interaction read_hand(const Node& node, Mistakes& mistakes) {
  Hand hand(node, mistakes);
  const Triple at = node.key == "move" ? Triple{0, 0, 0} : hand.place("at", farthest);
  if (node.key == "push") return Push{at, hand.radius(), hand.place("velocity", fastest)};
  if (node.key == "add")
    return AddParticles{at, hand.radius(), hand.place("velocity", fastest, std::vector<double>{0, 0})};
  if (node.key == "remove") return RemoveParticles{at, hand.radius()};
  const std::uint32_t solid = hand.solid();
  return MoveSolid{solid, hand.place("by", farthest), hand.over()};
}

std::string list(const Triple& t) {
  const bool flat = t[2] == 0;
  return to_toml(Value(flat ? std::vector<double>{t[0], t[1]} : std::vector<double>(t.begin(), t.end())));
}
std::string number(double x) {
  return to_toml(Value(x));
}

struct Say {
  std::string operator()(const Push& p) const {
    return "push = { at = " + list(p.at) + ", radius = " + number(p.radius) + ", velocity = " + list(p.velocity) + " }";
  }
  std::string operator()(const AddParticles& p) const {
    const std::string velocity = p.velocity == Triple{0, 0, 0} ? "" : ", velocity = " + list(p.velocity);
    return "add = { at = " + list(p.at) + ", radius = " + number(p.radius) + velocity + " }";
  }
  std::string operator()(const RemoveParticles& p) const {
    return "remove = { at = " + list(p.at) + ", radius = " + number(p.radius) + " }";
  }
  std::string operator()(const MoveSolid& p) const {
    return "move = { solid = " + std::to_string(p.solid + 1) + ", by = " + list(p.by) + ", over = " + number(p.over) +
           " }";
  }
  std::string operator()(const Interaction& a) const { return std::visit(*this, a); }
  std::string operator()(const SetParameter& s) const { return s.path + " = " + to_toml(s.value); }
};

} // namespace

void read_edit(const Node& node, std::vector<Edit>& edits, Mistakes& mistakes) {
  TableReader table(node, "an edit", mistakes);
  Edit edit;
  edit.t = table.number("t", 0, latest, std::nullopt);
  edit.pane = static_cast<int>(table.number("pane", 0, most_panes, 0.0));
  if (!edits.empty() && edit.t < edits.back().t && node.find("t"))
    mistakes.add("edits must be in the order of their times: t = " + to_toml(Value(edit.t)) +
                     " comes after t = " + to_toml(Value(edits.back().t)),
                 node.find("t")->where);
  std::size_t found = 0;
  for (const Node& entry : node.items) {
    if (entry.key == "t" || entry.key == "pane") continue;
    edit.where = entry.where;
    const bool hand = std::find(hands.begin(), hands.end(), entry.key) != hands.end();
    if (hand && entry.type == Node::Type::table) {
      edit.action = read_hand(entry, mistakes);
      edits.push_back(edit);
      ++found;
      continue;
    }
    std::vector<Assignment> values;
    flatten(entry, entry.key, values, mistakes);
    for (Assignment& a : values) {
      edit.where = a.where;
      edit.action = SetParameter{a.path, std::move(a.value)};
      edits.push_back(edit);
      ++found;
    }
  }
  if (found == 0)
    mistakes.add("an edit needs a parameter, for example transfer.flip_ratio = 0.5, or push, add, remove or move",
                 node.where);
}

std::string to_toml(const Edit& edit) {
  std::string text = "\n[[edit]]\nt = " + to_toml(Value(edit.t)) + "\n";
  if (edit.pane > 0) text += "pane = " + std::to_string(edit.pane) + "\n";
  return text + std::visit(Say{}, edit.action) + "\n";
}

} // namespace flipbook::app
