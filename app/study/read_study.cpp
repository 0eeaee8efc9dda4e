// SPDX-License-Identifier: MIT
#include "app/study/study.h"

#include "app/study/paths.h"
#include "render/compose/sheet_settings.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace flipbook::app {
namespace {

constexpr double longest = 1e6; // seconds

/// Everything in `table` but the reserved keys, as assignments.
std::vector<Assignment> parameters(const Node& table, const std::vector<std::string>& reserved, Mistakes& mistakes) {
  std::vector<Assignment> all;
  for (const Node& entry : table.items)
    if (std::find(reserved.begin(), reserved.end(), entry.key) == reserved.end())
      flatten(entry, entry.key, all, mistakes);
  return all;
}

/// The tables of a list such as [[variant]]; nothing if the key is not there.
std::vector<const Node*> tables(const Node* list, const std::string& key, Mistakes& mistakes) {
  std::vector<const Node*> all;
  if (!list) return all;
  if (list->type == Node::Type::list)
    for (const Node& entry : list->items)
      if (entry.type == Node::Type::table) all.push_back(&entry);
  if (list->type != Node::Type::list || all.size() != list->items.size())
    mistakes.add("a " + key + " is written as [[" + key + "]]", list->where);
  return all;
}

Ease read_ease(TableReader& table) {
  const std::string name = table.text("ease", "smooth");
  if (name == "smooth") return Ease::smooth;
  if (name == "linear") return Ease::linear;
  if (name == "step") return Ease::step;
  const std::vector<std::string> all{"smooth", "linear", "step"};
  table.mistake("there is no ease \"" + name + "\": it is \"smooth\", \"linear\" or \"step\"", *table.optional("ease"),
                nearest_name(name, all));
  return Ease::smooth;
}

/// `variant = "FLIP 0.97"`, `variant = 2` or `variant = [2, 3]`.
void read_variant_of(TableReader& table, Key& key, Mistakes& mistakes) {
  const Node* node = table.optional("variant");
  if (!node) return;
  const bool list = node->type == Node::Type::list && !node->items.empty();
  if (node->type == Node::Type::text) key.variant = node->text;
  for (const Node& n : list ? std::span(node->items) : std::span(node, 1)) {
    if (n.type == Node::Type::number && n.number == std::floor(n.number) && n.number >= 1 && n.number <= most_variants)
      key.panes.push_back(static_cast<int>(n.number));
    else if (key.variant.empty())
      return mistakes.add("\"variant\" must be a name, or a number from 1 to " + std::to_string(most_variants),
                          node->where);
  }
}

void read_key(const Node& node, Study& study, Mistakes& mistakes) {
  TableReader table(node, "a key", mistakes);
  Key key;
  key.t = table.number("t", 0, longest, std::nullopt);
  key.over = table.number("over", 0, longest, 0.0);
  key.ease = read_ease(table);
  read_variant_of(table, key, mistakes);
  key.label = table.text("label", "");
  if (!study.keys.empty() && key.t < study.keys.back().t && node.find("t"))
    mistakes.add("keys must be in the order of their times: t = " + to_toml(Value(key.t)) +
                     " comes after t = " + to_toml(Value(study.keys.back().t)),
                 node.find("t")->where);
  const auto moves = parameters(node, {"t", "over", "ease", "variant", "label"}, mistakes);
  if (moves.empty() && key.label.empty())
    mistakes.add("a key needs a parameter, for example transfer.flip_ratio = 0.5, or a label", node.where);
  if (moves.empty() && node.find("variant"))
    mistakes.add("a key that only has a label says it for all: it cannot name a variant", node.find("variant")->where);
  if (moves.empty()) {
    key.where = node.where;
    study.keys.push_back(key);
  }
  for (const Assignment& a : moves) {
    key.path = a.path;
    key.value = a.value;
    key.where = a.where;
    study.keys.push_back(key);
  }
}

/// Does the study show its variants as a contact sheet, which has more?
bool is_sheet(const Node& root) {
  const Node* view = root.find("view");
  const Node* layout = view ? view->find("layout") : nullptr;
  return layout && layout->text == "sheet";
}

void read_variants(const Node& root, Study& study, Mistakes& mistakes) {
  const Node* list = root.find("variant");
  for (const Node* node : tables(list, "variant", mistakes)) {
    TableReader table(*node, "a variant", mistakes);
    Variant v;
    v.label = table.text("label", "");
    v.where = node->where;
    v.parameters = parameters(*node, {"label"}, mistakes);
    study.variants.push_back(std::move(v));
  }
  if (!list) study.variants.emplace_back();
  const std::size_t most = is_sheet(root) ? render::most_sheet_panes : render::most_panes;
  if (list && (study.variants.empty() || study.variants.size() > most))
    mistakes.add(too_many_variants(study.variants.size(), most), list->where);
}

void read_scene_of(const Node& root, Study& study, const std::string& file, Mistakes& mistakes) {
  const Node* scene = root.find("scene");
  if (!scene) {
    const std::vector<std::string> meant{"scene"};
    const auto slip = std::find_if(root.items.begin(), root.items.end(),
                                   [&](const Node& entry) { return !nearest_name(entry.key, meant).empty(); });
    if (slip != root.items.end())
      mistakes.add("unknown key \"" + slip->key + "\"", slip->where, "scene");
    else
      mistakes.add("a study needs a scene, for example scene = \"dam_break\"", root.where);
  } else if (scene->type == Node::Type::table) {
    const Node* name = scene->find("name");
    study.scene = {name && name->type == Node::Type::text ? name->text : study.name, *scene};
  } else if (scene->type == Node::Type::text) {
    try {
      study.scene = load_scene(scene->text, std::filesystem::path(file).parent_path().string());
    } catch (const UserError& error) {
      // An error inside the scene's file has its own place; that there is no such scene belongs to this line.
      if (find_asset("scenes", scene->text, std::filesystem::path(file).parent_path().string())) throw;
      if (find_asset("studies", scene->text))
        mistakes.add("\"" + scene->text + "\" is a study; a scene is wanted here (flipbook list scenes)", scene->where);
      else
        mistakes.add(error.what(), scene->where);
    }
    if (study.scene.table.find("scene") || study.scene.table.find("variant"))
      mistakes.add("\"" + scene->text + "\" is a study; a scene is wanted here (flipbook list scenes)", scene->where);
  } else {
    mistakes.add("\"scene\" must be the name of a scene, a path or a table", scene->where);
  }
}

Study from_tree(const Node& root, const std::string& file) {
  Mistakes mistakes;
  Study study;
  study.name = stem(file);
  TableReader table(root, "the study", mistakes);
  study.title = table.text("title", "");
  read_scene_of(root, study, file, mistakes);
  read_variants(root, study, mistakes);
  for (const Node* node : tables(root.find("key"), "key", mistakes)) read_key(*node, study, mistakes);
  for (const Node* node : tables(root.find("edit"), "edit", mistakes)) read_edit(*node, study.edits, mistakes);
  if (const Node* references = root.find("reference")) study.references = *references;
  for (Assignment& a : parameters(root, {"title", "scene", "variant", "key", "edit", "reference"}, mistakes)) {
    (is_view(a.path) ? study.view : is_output(a.path) ? study.output : study.parameters).push_back(std::move(a));
  }
  mistakes.raise();
  return study;
}

Study of_scene(SceneText scene) {
  Study study;
  study.name = scene.name;
  study.scene = std::move(scene);
  study.variants.emplace_back();
  return study;
}

} // namespace

std::string too_many_variants(std::size_t variants, std::size_t most) {
  const std::string text = "a study has 1 to " + std::to_string(most) + " variants, not " + std::to_string(variants);
  if (variants < most || most == render::most_sheet_panes) return text;
  return text + "; with view.layout = \"sheet\" up to " + std::to_string(render::most_sheet_panes);
}

Study parse_study(std::string_view text, const std::string& file) {
  return from_tree(parse_toml(text, file), file);
}

Study study_of_scene(const std::string& name_or_path) {
  return of_scene(load_scene(name_or_path));
}

Study read_study(const std::string& name_or_path) {
  if (const auto path = find_asset("studies", name_or_path)) {
    Node root = parse_toml(read_text_file(*path), *path);
    // A file given by its path may be a scene: it has bodies and names no scene.
    if (!root.find("scene") && (root.find("body") || root.find("particles")))
      return of_scene({stem(*path), std::move(root)});
    return from_tree(root, *path);
  }
  if (is_path(name_or_path)) throw UserError("there is no file \"" + name_or_path + "\"");
  if (find_asset("scenes", name_or_path)) return study_of_scene(name_or_path);
  std::vector<std::string> names = list_studies();
  for (std::string& name : list_scenes()) names.push_back(std::move(name));
  throw UserError("there is no study or scene \"" + name_or_path + "\"", {}, nearest_name(name_or_path, names));
}

std::vector<std::string> list_studies() {
  return list_assets("studies");
}

void assign(Study& study, Assignment change) {
  // A range belongs to the quantity that it was written for.
  if (change.path == "view.colour") std::erase_if(study.view, [](auto& a) { return a.path == "view.range"; });
  study.overridden = true;
  for (Variant& v : study.variants) std::erase_if(v.parameters, [&](auto& a) { return a.path == change.path; });
  (is_view(change.path)     ? study.view
   : is_output(change.path) ? study.output
                            : study.parameters)
      .push_back(std::move(change));
}

} // namespace flipbook::app
