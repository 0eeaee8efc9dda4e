// SPDX-License-Identifier: MIT
#include "app/figures/spec.h"

#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace flipbook::app {

namespace {

constexpr double column = 84, text_width = 174, narrowest = 60, widest = 400; // mm

std::string required_text(TableReader& table, std::string_view key) {
  const Node* node = table.required(key);
  if (node && node->type != Node::Type::text) table.mistake(std::string(key) + " is a text", *node);
  return node && node->type == Node::Type::text ? node->text : "";
}

/// [run], then [fast] over it.
std::vector<Assignment> run_of(TableReader& table, bool fast, Mistakes& mistakes) {
  std::vector<Assignment> run, quick;
  if (const Node* node = table.optional("run")) flatten(*node, "", run, mistakes);
  if (const Node* node = table.optional("fast")) flatten(*node, "", quick, mistakes);
  if (fast) run.insert(run.end(), quick.begin(), quick.end());
  return run;
}

} // namespace

FigureSpec read_figure(const std::string& name_or_path, bool fast) {
  const auto path = find_asset("figures", name_or_path);
  if (!path)
    throw UserError("there is no figure \"" + name_or_path + "\"", {}, nearest_name(name_or_path, list_figures()));
  const Node root = parse_toml(read_text_file(*path), *path);
  Mistakes mistakes;
  TableReader table(root, "a figure", mistakes);
  FigureSpec spec;
  spec.name = stem(*path);
  spec.number = static_cast<int>(table.number("number", 1, 999, 999));
  spec.kind = required_text(table, "kind");
  spec.claim = required_text(table, "claim");
  spec.caption = required_text(table, "caption");
  spec.width = table.number("width", narrowest, widest, text_width);
  spec.run = run_of(table, fast, mistakes);
  table.done();
  mistakes.raise();
  return spec;
}

namespace {

constexpr double last_place = 999;

/// Where a figure says that it stands; last where its file cannot be read, which is no moment for a message.
double place_of(const std::string& name) {
  try {
    const auto path = find_asset("figures", name);
    const Node root = path ? parse_toml(read_text_file(*path), *path) : Node{};
    const Node* number = root.find("number");
    return number && number->type == Node::Type::number ? number->number : last_place;
  } catch (const UserError&) {
    return last_place;
  }
}

} // namespace

std::vector<std::string> list_figures() {
  std::vector<std::pair<double, std::string>> all;
  for (const std::string& name : list_assets("figures")) all.emplace_back(place_of(name), name);
  std::sort(all.begin(), all.end());
  std::vector<std::string> names;
  for (const auto& [number, name] : all) names.push_back(name);
  return names;
}

std::unique_ptr<FigureKind> kind_of(const FigureSpec& spec) {
  std::vector<std::string> names;
  for (const FigureKindEntry& entry : figure_kinds()) {
    names.push_back(entry.name);
    if (entry.name != spec.kind) continue;
    auto kind = entry.make();
    Mistakes mistakes;
    for (const Assignment& a : spec.run)
      if (const Refusal r = set_parameter(*kind, a.path, a.value); !r.message.empty())
        mistakes.add(r.message, a.where, r.nearest);
    mistakes.raise();
    return kind;
  }
  throw UserError(spec.name + ": there is no kind of figure \"" + spec.kind + "\"", {}, nearest_name(spec.kind, names));
}

double parse_width(const std::string& text) {
  if (text == "column") return column;
  if (text == "text") return text_width;
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  std::string unit(end, text.data() + text.size());
  std::erase(unit, ' ');
  const double mm = unit == "mm" ? 1 : unit == "cm" ? 10 : unit == "in" ? 25.4 : unit == "pt" ? 25.4 / 72 : 0;
  if (error != std::errc() || mm == 0)
    throw UserError("--width " + text + ": a length as in 84mm, 17.4cm or 6.5in, or column or text");
  if (!(number * mm >= narrowest && number * mm <= widest))
    throw UserError("--width " + text + ": it lies between 60 mm and 400 mm");
  return number * mm;
}

} // namespace flipbook::app
