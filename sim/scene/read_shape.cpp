// SPDX-License-Identifier: MIT
#include "sim/scene/read_shape.h"

#include "sim/scene/expression.h"
#include "sim/scene/read_mesh_shape.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

constexpr double far = 1e6; // metres; the largest domain
constexpr int deepest = 16; // shapes within shapes

/// What a shape is made from: its table, and a way to read the shapes inside it.
struct Source {
  TableReader& table;
  SceneFiles& files;
  Mistakes& mistakes;
  int depth;

  [[nodiscard]] Listed point(std::string_view key) const { return listed(table.numbers(key, 2, 3, std::nullopt)); }
  [[nodiscard]] double radius() const { return table.number("radius", 1e-9, far, std::nullopt); }
  [[nodiscard]] std::vector<ShapePtr> parts() const;
};

// === The list. A new shape is one entry here, made by a function of sim/boundary/shape.h.
struct Entry {
  ShapeInfo info;
  ShapePtr (*make)(const Source&);
};

ShapePtr box(const Source& s) {
  const Listed lo = s.point("lo"), hi = s.point("hi");
  const Node *lo_node = s.table.optional("lo"), *hi_node = s.table.optional("hi");
  if (!lo_node || !hi_node) return nullptr;
  if (lo.count != hi.count) s.table.mistake("\"lo\" and \"hi\" must list the same axes", *hi_node);
  for (std::size_t d = 0; d < static_cast<std::size_t>(lo.count); ++d)
    if (lo.x[d] > hi.x[d]) s.table.mistake("\"lo\" must not be above \"hi\" on any axis", *lo_node);
  return make_box(lo, hi);
}

ShapePtr half_space(const Source& s) {
  const Listed normal = s.point("normal");
  const Node* node = s.table.optional("normal");
  if (node && std::hypot(normal.x[0], normal.x[1], normal.x[2]) == 0)
    s.table.mistake("\"normal\" must not be zero", *node);
  return make_half_space(s.point("point"), normal);
}

ShapePtr implicit(const Source& s) {
  const Node* node = s.table.required("phi");
  const std::string formula = s.table.text("phi", "");
  if (!node || node->type != Node::Type::text) return nullptr;
  return make_implicit(Expression(formula, {"x", "y", "z"}, node->where));
}

template <ShapePtr (*combine)(std::vector<ShapePtr>)> ShapePtr combined(const Source& s) {
  std::vector<ShapePtr> parts = s.parts();
  return parts.empty() ? nullptr : combine(std::move(parts));
}

constexpr Entry shapes[] = {
    {{"box", "lo, hi", "Between two corners; spans the domain along an axis that is not listed"}, box},
    {{"ball", "centre, radius", "A circle in 2D, a sphere in 3D"},
     [](const Source& s) { return make_ball(s.point("centre"), s.radius()); }},
    {{"disc", "centre, radius", "A circle in 2D, a cylinder along z through the whole domain in 3D"},
     [](const Source& s) { return make_disc(s.point("centre"), s.radius()); }},
    {{"capsule", "a, b, radius", "All points within the radius of the segment from a to b"},
     [](const Source& s) { return make_capsule(s.point("a"), s.point("b"), s.radius()); }},
    {{"half_space", "point, normal", "The side of a plane that its normal points away from"}, half_space},
    {{"implicit", "phi", "Where a formula in x, y, z is negative"}, implicit},
    {{"mesh", "file, unit, scale, rotate, translate, fit", "What closed triangle meshes enclose: OBJ, STL or PLY"},
     [](const Source& s) { return read_mesh_shape(s.table, s.files, s.mistakes); }},
    {{"union", "of", "What is in any of the shapes"}, combined<make_union>},
    {{"difference", "of", "What is in the first shape and in none of the others"}, combined<make_difference>},
    {{"intersection", "of", "What is in all the shapes"}, combined<make_intersection>},
};

std::string article(std::string_view name) {
  const bool vowel = name.find_first_of("aeiou") == 0 && name != "union";
  return std::string(vowel ? "an " : "a ").append(name);
}

ShapePtr read_shape(const Node& table, SceneFiles& files, Mistakes& mistakes, int depth,
                    std::span<const std::string_view> also) {
  const Node* name = table.type == Node::Type::table ? table.find("shape") : nullptr;
  if (!name || name->type != Node::Type::text) {
    mistakes.add("a shape by name is needed here, for example shape = \"box\"", name ? name->where : table.where);
    return nullptr;
  }
  const auto entry =
      std::find_if(std::begin(shapes), std::end(shapes), [&](const Entry& e) { return e.info.name == name->text; });
  if (entry == std::end(shapes)) {
    std::vector<std::string> names;
    for (const Entry& e : shapes) names.emplace_back(e.info.name);
    mistakes.add("there is no shape \"" + name->text + "\"", name->where, nearest_name(name->text, names));
    return nullptr;
  }
  TableReader reader(table, article(name->text), mistakes);
  (void)reader.optional("shape");
  for (const std::string_view key : also) (void)reader.optional(key);
  ShapePtr shape;
  try {
    shape = entry->make({reader, files, mistakes, depth});
  } catch (const UserError& error) {
    mistakes.add(error);
  }
  reader.done();
  return shape;
}

std::vector<ShapePtr> Source::parts() const {
  std::vector<ShapePtr> all;
  const Node* list = table.required("of");
  if (!list) return all;
  if (list->type != Node::Type::list || list->items.empty() || depth >= deepest) {
    table.mistake(depth >= deepest ? "shapes are nested too deeply" : "\"of\" must be a list of shapes", *list);
    return all;
  }
  for (const Node& part : list->items) {
    ShapePtr shape = read_shape(part, files, mistakes, depth + 1, {});
    if (!shape) return {}; // a mistake is on record
    all.push_back(std::move(shape));
  }
  return all;
}

} // namespace

Listed listed(const std::vector<double>& numbers) {
  Listed p;
  p.count = static_cast<int>(numbers.size());
  std::copy(numbers.begin(), numbers.end(), p.x.begin());
  return p;
}

ShapePtr read_shape(const Node& table, std::span<const std::string_view> also, SceneFiles& files, Mistakes& mistakes) {
  return read_shape(table, files, mistakes, 0, also);
}

std::vector<ShapeInfo> list_shapes() {
  std::vector<ShapeInfo> all;
  for (const Entry& e : shapes) all.push_back(e.info);
  return all;
}

} // namespace flipbook
