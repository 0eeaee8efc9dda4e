// SPDX-License-Identifier: MIT
#include "sim/scene/read_mesh_shape.h"

#include "sim/boundary/mesh_check.h"
#include "sim/boundary/mesh_shape.h"
#include "sim/files/read_mesh.h"
#include "sim/scene/assets.h"
#include "sim/scene/read_placement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

namespace flipbook {
namespace {

constexpr double far = 1e6; // metres; the largest domain

/// The box of `fit`, infinite along z where that is not listed.
struct Fit {
  Point lo{-far, -far, -far}, hi{far, far, far};
  bool lists_z = false;
};

std::optional<Fit> read_fit(TableReader& table) {
  const Node* node = table.optional("fit");
  if (!node) return std::nullopt;
  Fit fit;
  bool good = node->type == Node::Type::list && node->items.size() == 2;
  for (std::size_t end = 0; good && end < 2; ++end) {
    const Node& corner = node->items[end];
    const std::size_t n = corner.items.size();
    good = corner.type == Node::Type::list && (n == 2 || n == 3) && n == node->items[0].items.size();
    fit.lists_z = n == 3;
    for (std::size_t d = 0; good && d < n; ++d) {
      const Node& x = corner.items[d];
      good = x.type == Node::Type::number && std::abs(x.number) <= far;
      (end == 0 ? fit.lo : fit.hi)[d] = x.number;
    }
  }
  for (std::size_t d = 0; d < 3; ++d) good = good && fit.lo[d] < fit.hi[d];
  if (!good) {
    table.mistake("\"fit\" must be the lower and the upper corner of a box, such as [[0, 0, 0], [1, 1, 1]], not " +
                      to_toml(*node),
                  *node);
    return std::nullopt;
  }
  for (const char* other : {"unit", "scale", "translate"})
    if (const Node* also = table.optional(other))
      table.mistake(std::string("\"") + other + "\" and \"fit\" cannot both say how large the mesh is and where",
                    *also);
  return fit;
}

/// A box around the mesh when only its linear part has been applied.
std::pair<Point, Point> extent(const Mesh& mesh, const Affine& placement) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Point lo{inf, inf, inf}, hi{-inf, -inf, -inf};
  for (const auto& x : mesh.vertices) {
    const Point p = placement.turn(x);
    for (std::size_t d = 0; d < 3; ++d) lo[d] = std::min(lo[d], p[d]), hi[d] = std::max(hi[d], p[d]);
  }
  return {lo, hi};
}

void put_into(const Fit& fit, const Mesh& mesh, Affine& placement) {
  const auto [lo, hi] = extent(mesh, placement);
  double scale = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < 3; ++d) scale = std::min(scale, (fit.hi[d] - fit.lo[d]) / (hi[d] - lo[d]));
  for (double& entry : placement.linear) entry *= scale;
  for (std::size_t d = 0; d < 3; ++d) placement.shift[d] = (fit.lo[d] + fit.hi[d] - scale * (lo[d] + hi[d])) / 2;
  placement.lists_z = fit.lists_z;
}

Mesh placed(const Mesh& mesh, const Affine& placement, const std::string& name) {
  Mesh world = mesh;
  double reach = 0;
  for (auto& x : world.vertices) {
    x = placement.apply(x);
    for (const double c : x) reach = std::max(reach, std::abs(c));
  }
  if (!(reach <= 2 * far)) {
    char metres[32];
    std::snprintf(metres, sizeof metres, "%.3g", reach);
    throw UserError(name + " reaches to " + metres + " m: give its \"unit\", or the box that it should \"fit\"");
  }
  return world;
}

/// The text of the keys that decide the shape, by which shapes are shared.
std::string key_of(TableReader& table) {
  std::string text = "mesh";
  for (const char* key : {"unit", "scale", "rotate", "translate", "fit"})
    if (const Node* node = table.optional(key)) text += std::string(" ") + key + "=" + to_toml(*node);
  return text;
}

} // namespace

ShapePtr read_mesh_shape(TableReader& table, SceneFiles& files, Mistakes& mistakes) {
  const Node* file = table.required("file");
  const std::string name = table.text("file", "");
  Affine placement = read_placement(table, mistakes);
  const std::optional<Fit> fit = read_fit(table);
  if (!file || file->type != Node::Type::text) return nullptr;
  const std::string path = find_input("meshes", name, file->where), quoted = "\"" + name + "\"";
  try {
    const auto solid = files.get<Mesh>("solid", path, [&](const std::string& at) {
      Mesh mesh = read_mesh(at);
      make_solid(mesh, quoted);
      return mesh;
    });
    if (fit) put_into(*fit, *solid, placement);
    // Built once for all variants of the scene: for a large mesh that takes seconds.
    return *files.get<ShapePtr>(key_of(table), path, [&](const std::string&) {
      return make_mesh_shape(placed(*solid, placement, quoted), !placement.lists_z);
    });
  } catch (const UserError& error) {
    throw UserError(error.what(), file->where);
  }
}

} // namespace flipbook
