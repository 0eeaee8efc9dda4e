// SPDX-License-Identifier: MIT
#include "app/study/study.h"

#include "app/study/output_settings.h"
#include "render/view_settings.h"

#include <algorithm>

namespace flipbook::app {
namespace {

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

std::string scene_text(const SceneText& scene) {
  std::string text = "\n[scene]\n" + line("name", to_toml(Value(scene.name)));
  for (const Node& entry : scene.table.items)
    if (entry.key != "body" && entry.key != "name") write_entries(entry, entry.key, text);
  const Node* bodies = scene.table.find("body");
  if (!bodies) return text;
  for (const Node& body : bodies->items) {
    text += "\n[[scene.body]]\n";
    for (const Node& entry : body.items) text += line(entry.key, to_toml(entry));
  }
  return text;
}

std::string key_text(const Key& key) {
  std::string text = "\n[[key]]\n" + line("t", to_toml(Value(key.t)));
  if (key.over > 0) text += line("over", to_toml(Value(key.over)));
  if (key.ease != Ease::smooth) text += line("ease", key.ease == Ease::linear ? "\"linear\"" : "\"step\"");
  if (key.panes.size() == 1) text += line("variant", to_toml(Value(static_cast<double>(key.panes.front()))));
  if (key.panes.size() > 1)
    text += line("variant", to_toml(Value(std::vector<double>(key.panes.begin(), key.panes.end()))));
  if (!key.variant.empty()) text += line("variant", to_toml(Value(key.variant)));
  return text + line(key.path, to_toml(key.value));
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
  return text;
}

} // namespace flipbook::app
