// SPDX-License-Identifier: MIT
#include "sim/scene/read_reference.h"

#include "sim/files/number_table.h"
#include "sim/scene/assets.h"
#include "sim/scene/expression.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flipbook {
namespace {

constexpr double largest = 1e12; // of a scale

/// A number, or a formula without variables: "sqrt(0.4 / 9.81)".
double read_scale(TableReader& table, const char* key, double fallback, Mistakes& mistakes) {
  const Node* node = table.optional(key);
  if (!node) return fallback;
  double value = fallback;
  if (node->type == Node::Type::text)
    value = Expression(node->text, {}, node->where)({});
  else if (node->type == Node::Type::number)
    value = node->number;
  else
    mistakes.add(std::string("\"") + key + "\" must be a number or a formula in quotes, not " + to_toml(*node),
                 node->where);
  if (std::abs(value) <= largest) return value;
  mistakes.add(std::string("\"") + key + "\" must be within ±1e12, not " + to_toml(Value(value)), node->where);
  return fallback;
}

ReferenceCurve::Style read_style(TableReader& table) {
  const std::string name = table.text("style", "points");
  if (name == "points") return ReferenceCurve::Style::points;
  if (name == "line") return ReferenceCurve::Style::line;
  const std::vector<std::string> all{"points", "line"};
  table.mistake("there is no style \"" + name + R"(": it is "points" or "line")", *table.optional("style"),
                nearest_name(name, all));
  return ReferenceCurve::Style::points;
}

struct Request {
  std::string written; ///< the file
  const Node *file = nullptr, *x = nullptr, *y = nullptr;
  double x_scale = 1, y_scale = 1, t0 = 0;
};

/// The column of this name; the n-th where none is asked for.
const std::vector<double>& column(const NumberTable& table, const Node* name, std::size_t n, const Node& file) {
  if (!name && n < table.columns.size()) return table.columns[n];
  if (!name) throw UserError("the table has one column, and two are needed", file.where);
  const auto at = std::find(table.names.begin(), table.names.end(), name->text);
  if (at == table.names.end())
    throw UserError("the table has no column \"" + name->text + "\"", name->where,
                    nearest_name(name->text, table.names));
  return table.columns[static_cast<std::size_t>(at - table.names.begin())];
}

/// In the order of their times.
void fill(ReferenceCurve& curve, const NumberTable& table, const Request& r) {
  const std::vector<double>&x = column(table, r.x, 0, *r.file), &y = column(table, r.y, 1, *r.file);
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return r.x_scale * x[a] < r.x_scale * x[b]; });
  for (const std::size_t i : order) {
    curve.t.push_back(r.t0 + r.x_scale * x[i]);
    curve.y.push_back(r.y_scale * y[i]);
    if (!std::isfinite(curve.t.back()) || !std::isfinite(curve.y.back()))
      throw UserError("row " + std::to_string(i + 1) + " of the table is not finite after scaling", r.file->where);
  }
}

ReferenceCurve read_reference(const Node& node, SceneFiles& files, Mistakes& mistakes) {
  ReferenceCurve curve;
  TableReader table(node, "a reference", mistakes);
  const Node* plot = table.required("plot");
  curve.plot = table.text("plot", "");
  curve.where = plot ? plot->where : node.where;
  Request r;
  r.file = table.required("file");
  r.written = table.text("file", "");
  curve.label = table.text("label", stem(r.written));
  curve.style = read_style(table);
  (void)table.text("x", ""), (void)table.text("y", "");
  r.x = node.find("x"), r.y = node.find("y");
  r.x_scale = read_scale(table, "x_scale", 1, mistakes);
  r.y_scale = read_scale(table, "y_scale", 1, mistakes);
  r.t0 = table.number("t0", -1e6, 1e6, 0.0);
  table.done();
  if (!r.file || r.written.empty()) return curve;
  const std::string path = find_input("reference", r.written, r.file->where);
  fill(curve, *files.get<NumberTable>("table", path, read_number_table), r);
  return curve;
}

} // namespace

std::vector<ReferenceCurve> read_references(const Node& list, SceneFiles& files, Mistakes& mistakes) {
  std::vector<ReferenceCurve> all;
  const bool tables =
      list.type == Node::Type::list &&
      std::all_of(list.items.begin(), list.items.end(), [](const Node& n) { return n.type == Node::Type::table; });
  if (!tables) {
    mistakes.add("references are written as [[reference]]", list.where);
    return all;
  }
  if (list.items.size() > most_references) {
    mistakes.add("there may be " + std::to_string(most_references) + " references, not " +
                     std::to_string(list.items.size()),
                 list.where);
    return all;
  }
  for (const Node& node : list.items) {
    try {
      all.push_back(read_reference(node, files, mistakes));
    } catch (const UserError& error) {
      mistakes.add(error);
    }
  }
  return all;
}

} // namespace flipbook
