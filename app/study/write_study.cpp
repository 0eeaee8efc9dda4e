// SPDX-License-Identifier: MIT
#include "app/study/study.h"

#include "app/study/output_settings.h"
#include "app/study/relative_path.h"
#include "render/view_settings.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <filesystem>

namespace flipbook::app {
namespace {

namespace fs = std::filesystem;

std::string line(const std::string& path, const std::string& value) {
  std::string keys;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    keys.append(keys.empty() ? "" : ".").append(toml_key(path.substr(begin, dot - begin)));
    begin = dot + 1;
  }
  return keys + " = " + value + "\n";
}

/// The last assignment of each path, in the order in which `component` describes them.
template <Described T> std::string lines(std::span<const Assignment> assignments, T component) {
  std::vector<std::string> order;
  for (const Parameter& p : parameters_of(component)) order.push_back(p.path);
  std::vector<const Assignment*> last;
  for (const Assignment& a : assignments) {
    std::erase_if(last, [&](const Assignment* b) { return b->path == a.path; });
    last.push_back(&a);
  }
  const auto rank = [&](const Assignment* a) { return std::find(order.begin(), order.end(), a->path) - order.begin(); };
  std::stable_sort(last.begin(), last.end(), [&](auto* a, auto* b) { return rank(a) < rank(b); });
  std::string text;
  for (const Assignment* a : last) text += line(a->path, to_toml(a->value));
  return text;
}

/// The entries of a table with dotted keys for the tables inside it.
void write_entries(const Node& node, const std::string& path, std::string& text) {
  if (node.type != Node::Type::table) {
    text += line(path, to_toml(node));
    return;
  }
  for (const Node& n : node.items) write_entries(n, path.empty() ? n.key : path + "." + n.key, text);
}

/// [[body]], [[particles]], ...
bool lists_tables(const Node& entry) {
  return entry.type == Node::Type::list && !entry.items.empty() &&
         std::all_of(entry.items.begin(), entry.items.end(), [](auto& n) { return n.type == Node::Type::table; });
}

/// [[name]] for each table of a list.
std::string table_texts(const std::string& name, const Node& list) {
  std::string text;
  for (const Node& table : list.items) {
    text += "\n[[" + name + "]]\n";
    for (const Node& entry : table.items) text += line(entry.key, to_toml(entry));
  }
  return text;
}

std::string scene_text(const SceneText& scene) {
  std::string text = "\n[scene]\n" + line("name", to_toml(Value(scene.name)));
  for (const Node& entry : scene.table.items)
    if (!lists_tables(entry) && entry.key != "name") write_entries(entry, entry.key, text);
  for (const Node& list : scene.table.items)
    if (lists_tables(list)) text += table_texts("scene." + toml_key(list.key), list);
  return text;
}

/// The same file named from `folder`.
std::string moved(std::string_view kind, const Node& name, const fs::path& folder) {
  if (fs::path(name.text).is_absolute()) return name.text;
  const fs::path file = find_input(kind, name.text, name.where);
  std::error_code none;
  if (fs::equivalent(folder / name.text, file, none)) return name.text;
  if (!fs::exists(folder / name.text, none) && find_asset_file(kind, name.text) == file.string()) return name.text;
  return relative_path(file, folder);
}

/// Shapes may lie within shapes: every `file` below the node.
void move_files(std::string_view kind, Node& node, const fs::path& folder) {
  if (node.key == "file" && node.type == Node::Type::text) node.text = moved(kind, node, folder);
  for (Node& n : node.items) move_files(kind, n, folder);
}

/// The folder of the assets where the files of a list are.
std::string_view kind_of_files(const std::string& key) {
  return key == "particles" || key == "reference" ? std::string_view(key) : "meshes";
}

std::string key_text(const Key& key) {
  std::string text = "\n[[key]]\n" + line("t", to_toml(Value(key.t)));
  if (key.over > 0) text += line("over", to_toml(Value(key.over)));
  if (key.ease != Ease::smooth) text += line("ease", key.ease == Ease::linear ? "\"linear\"" : "\"step\"");
  if (key.panes.size() == 1) text += line("variant", to_toml(Value(static_cast<double>(key.panes.front()))));
  if (key.panes.size() > 1)
    text += line("variant", to_toml(Value(std::vector<double>(key.panes.begin(), key.panes.end()))));
  if (!key.label.empty()) text += line("label", to_toml(Value(key.label)));
  if (!key.variant.empty()) text += line("variant", to_toml(Value(key.variant)));
  return key.path.empty() ? text : text + line(key.path, to_toml(key.value));
}

} // namespace

std::string to_toml(const Study& study) {
  std::string text;
  if (!study.title.empty()) text += line("title", to_toml(Value(study.title)));
  text += lines(study.parameters, Settings());
  text += lines(study.view, render::ViewSettings());
  text += lines(study.output, OutputSettings());
  text += scene_text(study.scene);
  for (const Variant& v : study.variants) {
    text += "\n[[variant]]\n";
    if (!v.label.empty()) text += line("label", to_toml(Value(v.label)));
    text += lines(v.parameters, Settings());
  }
  for (const Key& key : study.keys) text += key_text(key);
  for (const Edit& edit : study.edits) text += to_toml(edit);
  if (study.references) text += table_texts("reference", *study.references);
  return text;
}

Study for_folder(Study study, const std::string& folder) {
  for (Node& entry : study.scene.table.items)
    if (lists_tables(entry)) move_files(kind_of_files(entry.key), entry, fs::absolute(folder));
  if (study.references) move_files("reference", *study.references, fs::absolute(folder));
  return study;
}

} // namespace flipbook::app
