// SPDX-License-Identifier: MIT
#include "sim/boundary/mesh_check.h"

#include "sim/boundary/winding.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace flipbook {
namespace {

using Vector = Vec<3, double>;
constexpr std::uint32_t nobody = ~0U;

Vector at(const Mesh& mesh, std::uint32_t v) {
  return Vector(mesh.vertices[v].data());
}

/// The side of a triangle that starts at its corner slot % 3, with its ends in order.
struct Side {
  std::uint32_t lo, hi, slot;
  bool forwards; ///< from lo to hi
};

std::vector<Side> sorted_sides(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.lo != b.lo) return a.lo < b.lo;
    return a.hi != b.hi ? a.hi < b.hi : a.slot < b.slot;
  });
  return sides;
}

std::string place(const Mesh& mesh, const Side& side) {
  const Vector middle = (at(mesh, side.lo) + at(mesh, side.hi)) / 2;
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", middle[0], middle[1], middle[2]);
  return text;
}

/// For each side of each triangle, the triangle beyond it; and does that one run along it in the opposite direction?
struct Neighbours {
  std::vector<std::uint32_t> beyond;
  std::vector<bool> agree;
};

/// Edges that do not have two triangles, told once for each kind of them.
struct Wrong {
  std::size_t count = 0;
  Side first{};
  void add(const Side& side) {
    if (count++ == 0) first = side;
  }
  [[nodiscard]] std::string text(const Mesh& mesh, std::size_t edges, const char* have) const {
    return std::to_string(count) + " of " + std::to_string(edges) + (count == 1 ? " edges has " : " edges have ") +
           have + ", the first at " + place(mesh, first);
  }
};

Neighbours neighbours_of(const Mesh& mesh, const std::string& name) {
  const std::vector<Side> sides = sorted_sides(mesh);
  Neighbours n{std::vector<std::uint32_t>(sides.size(), nobody), std::vector<bool>(sides.size(), true)};
  Wrong open, crowded;
  std::size_t edges = 0;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end, ++edges) {
    while (end < sides.size() && sides[end].lo == sides[i].lo && sides[end].hi == sides[i].hi) ++end;
    if (end - i == 1) open.add(sides[i]);
    if (end - i > 2) crowded.add(sides[i]);
    if (end - i != 2) continue;
    const Side &a = sides[i], &b = sides[i + 1];
    n.beyond[a.slot] = b.slot / 3, n.beyond[b.slot] = a.slot / 3;
    n.agree[a.slot] = n.agree[b.slot] = a.forwards != b.forwards;
  }
  if (open.count > 0)
    throw UserError(name + " is not closed: " + open.text(mesh, edges, "one triangle only") +
                    "; a solid needs a closed surface");
  if (crowded.count > 0)
    throw UserError(name + " is not the surface of a solid: " + crowded.text(mesh, edges, "more than two triangles"));
  return n;
}

struct Component {
  std::vector<std::uint32_t> triangles;
  double volume = 0; ///< signed
  Eigen::AlignedBox3d box;
  bool turned = false;
};

void turn(Mesh& mesh, std::uint32_t t) {
  std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

double six_volumes(const Mesh& mesh, std::uint32_t t, const Vector& from) {
  const auto& corner = mesh.triangles[t];
  const Vector a = at(mesh, corner[0]) - from, b = at(mesh, corner[1]) - from, c = at(mesh, corner[2]) - from;
  return a.dot(b.cross(c));
}

/// Walks from triangle to triangle; a neighbour that disagrees is turned.
std::vector<Component> connected(Mesh& mesh, const Neighbours& n, const std::string& name) {
  enum : char { unvisited, kept, turned };
  std::vector<char> state(mesh.triangles.size(), unvisited);
  std::vector<Component> all;
  for (std::uint32_t seed = 0; seed < state.size(); ++seed) {
    if (state[seed] != unvisited) continue;
    Component c;
    c.triangles = {seed};
    state[seed] = kept;
    for (std::size_t done = 0; done < c.triangles.size(); ++done) {
      const std::uint32_t t = c.triangles[done];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = n.beyond[3 * t + k];
        const char wanted = (state[t] == kept) == n.agree[3 * t + k] ? kept : turned;
        if (state[other] == unvisited) {
          state[other] = wanted;
          c.triangles.push_back(other);
        } else if (state[other] != wanted) {
          throw UserError(name + " has no inside: its triangles cannot all be turned to face the same side");
        }
      }
    }
    all.push_back(std::move(c));
  }
  for (std::uint32_t t = 0; t < state.size(); ++t)
    if (state[t] == turned) turn(mesh, t);
  return all;
}

void measure(const Mesh& mesh, Component& c) {
  for (const std::uint32_t t : c.triangles)
    for (const std::uint32_t v : mesh.triangles[t]) c.box.extend(at(mesh, v));
  for (const std::uint32_t t : c.triangles) c.volume += six_volumes(mesh, t, c.box.center()) / 6;
}

bool surrounds(const Mesh& mesh, const Component& c, const Vector& p) {
  if (!c.box.contains(p)) return false;
  double omega = 0;
  for (const std::uint32_t t : c.triangles) {
    const auto& corner = mesh.triangles[t];
    omega += solid_angle(at(mesh, corner[0]) - p, at(mesh, corner[1]) - p, at(mesh, corner[2]) - p);
  }
  return std::abs(omega) > 2 * std::numbers::pi * (1 + 1e-6); // a point on a flat face sees exactly half
}

/// From the outermost to the innermost, so that a component finds those around it done.
void turn_outwards(Mesh& mesh, std::vector<Component>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(all[a].volume) > std::abs(all[b].volume); });
  const auto sign = [](const Component& c) { return (c.volume < 0) == c.turned ? 1 : -1; };
  for (std::size_t i = 0; i < order.size(); ++i) {
    Component& c = all[order[i]];
    const auto& corner = mesh.triangles[c.triangles.front()];
    const Vector p = (at(mesh, corner[0]) + at(mesh, corner[1]) + at(mesh, corner[2])) / 3;
    int winding = 0;
    for (std::size_t j = 0; j < i; ++j)
      if (const Component& outer = all[order[j]]; surrounds(mesh, outer, p)) {
        winding += sign(outer);
        c.turned = outer.turned; // the last one is the innermost
      }
    if (winding + sign(c) < 0) c.turned = !c.turned;
  }
  for (const Component& c : all)
    if (c.turned)
      for (const std::uint32_t t : c.triangles) turn(mesh, t);
}

void refuse_flat(const Mesh& mesh, const std::vector<Component>& all, const std::string& name) {
  double space = 0, area = 0;
  Eigen::AlignedBox3d box;
  for (const Component& c : all) space += std::abs(c.volume), box.extend(c.box);
  for (const auto& t : mesh.triangles)
    area += (at(mesh, t[1]) - at(mesh, t[0])).cross(at(mesh, t[2]) - at(mesh, t[0])).norm() / 2;
  if (!(space > 1e-9 * area * box.diagonal().norm())) throw UserError(name + " is flat: it encloses no volume");
}

} // namespace

void make_solid(Mesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) throw UserError(name + " has no triangles");
  std::vector<Component> all = connected(mesh, neighbours_of(mesh, name), name);
  for (Component& c : all) measure(mesh, c);
  refuse_flat(mesh, all, name);
  turn_outwards(mesh, all);
}

double enclosed_volume(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& x : mesh.vertices) box.extend(Vector(x.data()));
  double sum = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) sum += six_volumes(mesh, t, box.center());
  return sum / 6;
}

} // namespace flipbook
