// SPDX-License-Identifier: MIT
#include "sim/scene/read_placement.h"

#include <cmath>
#include <numbers>

namespace flipbook {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};
constexpr Unit units[] = {{"um", 1e-6}, {"mm", 1e-3},   {"cm", 1e-2},  {"m", 1},
                          {"km", 1e3},  {"in", 0.0254}, {"ft", 0.3048}};

double read_unit(TableReader& table) {
  const std::string name = table.text("unit", "m");
  std::string names;
  std::vector<std::string> all;
  for (const Unit& unit : units) {
    if (unit.name == name) return unit.metres;
    all.emplace_back(unit.name);
    names.append(names.empty() ? "" : ", ").append(unit.name);
  }
  if (const Node* node = table.optional("unit"); node && node->type == Node::Type::text)
    table.mistake("\"unit\" must be one of " + names, *node, nearest_name(name, all));
  return 1;
}

std::array<double, 3> read_scale(TableReader& table) {
  constexpr double least = 1e-9, most = 1e9;
  const Node* node = table.optional("scale");
  if (!node || node->type != Node::Type::list) {
    const double one = table.number("scale", least, most, 1.0);
    return {one, one, one};
  }
  const std::vector<double> given = table.numbers("scale", 3, 3, std::nullopt);
  for (const double s : given)
    if (!(s >= least && s <= most)) {
      table.mistake("\"scale\" must be positive along each axis (1e-9 to 1e9), not " + to_toml(*node), *node);
      return {1, 1, 1};
    }
  return {given[0], given[1], given[2]};
}

/// Quarter turns are exact, so that a body set upright stands on its plane.
void sine_and_cosine(double degrees, double& s, double& c) {
  const double quarters = degrees / 90;
  if (quarters == std::floor(quarters)) {
    const auto k = static_cast<int>(quarters - 4 * std::floor(quarters / 4));
    constexpr std::array<double, 4> sines{0, 1, 0, -1};
    s = sines[static_cast<std::size_t>(k)];
    c = sines[static_cast<std::size_t>((k + 1) % 4)];
    return;
  }
  s = std::sin(degrees * std::numbers::pi / 180);
  c = std::cos(degrees * std::numbers::pi / 180);
}

/// R = cos I + sin [a]x + (1 - cos) a aT (Rodrigues), for a unit axis a.
std::array<double, 9> rotation(std::array<double, 3> a, double degrees) {
  const double length = std::hypot(a[0], a[1], a[2]);
  for (double& x : a) x /= length;
  double s = 0, c = 1;
  sine_and_cosine(degrees, s, c);
  const double k = 1 - c;
  return {c + k * a[0] * a[0],        k * a[0] * a[1] - s * a[2], k * a[0] * a[2] + s * a[1],
          k * a[1] * a[0] + s * a[2], c + k * a[1] * a[1],        k * a[1] * a[2] - s * a[0],
          k * a[2] * a[0] - s * a[1], k * a[2] * a[1] + s * a[0], c + k * a[2] * a[2]};
}

std::array<double, 9> times(const std::array<double, 9>& a, const std::array<double, 9>& b) {
  std::array<double, 9> product{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) product[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return product;
}

std::array<double, 9> read_rotation(const Node& node, Mistakes& mistakes) {
  TableReader turn(node, "a rotation", mistakes);
  const std::vector<double> axis = turn.numbers("axis", 3, 3, std::nullopt);
  const double degrees = turn.number("degrees", -3600, 3600, std::nullopt);
  turn.done();
  const Node* given = node.find("axis");
  if (!given || !node.find("degrees")) return Affine().linear; // a mistake is on record
  if (std::hypot(axis[0], axis[1], axis[2]) == 0) {
    if (given->type == Node::Type::list) turn.mistake("\"axis\" must not be zero", *given);
    return Affine().linear;
  }
  return rotation({axis[0], axis[1], axis[2]}, degrees);
}

std::array<double, 9> read_rotations(TableReader& table, Mistakes& mistakes) {
  std::array<double, 9> all = Affine().linear;
  const Node* node = table.optional("rotate");
  if (!node) return all;
  const bool list = node->type == Node::Type::list;
  if (!list && node->type != Node::Type::table) {
    table.mistake("\"rotate\" must be a table such as { axis = [0, 1, 0], degrees = 30 }, not " + to_toml(*node),
                  *node);
    return all;
  }
  if (!list) return read_rotation(*node, mistakes);
  for (const Node& one : node->items) {
    if (one.type != Node::Type::table) {
      table.mistake("\"rotate\" must list tables such as { axis = [0, 1, 0], degrees = 30 }, not " + to_toml(one), one);
      return all;
    }
    all = times(read_rotation(one, mistakes), all);
  }
  return all;
}

} // namespace

std::array<double, 3> Affine::turn(const std::array<double, 3>& v) const {
  std::array<double, 3> turned{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) turned[i] += linear[3 * i + j] * v[j];
  return turned;
}

std::array<double, 3> Affine::apply(const std::array<double, 3>& x) const {
  const std::array<double, 3> turned = turn(x);
  return {turned[0] + shift[0], turned[1] + shift[1], turned[2] + shift[2]};
}

Affine read_placement(TableReader& table, Mistakes& mistakes) {
  Affine placement;
  const double unit = read_unit(table);
  const std::array<double, 3> scale = read_scale(table);
  placement.linear = read_rotations(table, mistakes);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) placement.linear[3 * i + j] *= unit * scale[j];
  const std::vector<double> translate = table.numbers("translate", 2, 3, std::vector<double>{0, 0, 0});
  for (std::size_t d = 0; d < translate.size(); ++d) placement.shift[d] = translate[d];
  placement.lists_z = translate.size() == 3;
  return placement;
}

} // namespace flipbook
