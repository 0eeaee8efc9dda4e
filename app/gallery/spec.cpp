// SPDX-License-Identifier: MIT
#include "app/gallery/spec.h"

#include "app/commands/variants.h"
#include "app/gallery/exhibit.h"
#include "app/study/study.h"
#include "render/compose/sheet_settings.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app::gallery {

namespace {

constexpr double latest = 1e6; // seconds

std::vector<Assignment> assignments(const Node* table, Mistakes& mistakes) {
  std::vector<Assignment> all;
  if (!table) return all;
  if (table->type == Node::Type::table)
    flatten(*table, "", all, mistakes);
  else
    mistakes.add("\"" + table->key + "\" is a table of parameters, as in " + table->key + " = { output.fps = 20 }",
                 table->where);
  return all;
}

bool read_flag(TableReader& table, std::string_view key) {
  const Node* node = table.optional(key);
  if (node && node->type != Node::Type::flag) table.mistake(std::string(key) + " is true or false", *node);
  return node && node->flag;
}

/// The one key that says what an entry shows.
void read_what(TableReader& table, const Node& node, Entry& entry, Mistakes& mistakes) {
  std::string kinds;
  for (const ExhibitKind& k : exhibit_kinds()) {
    const std::string name(k.name);
    kinds += (kinds.empty() ? "" : &k == &exhibit_kinds().back() ? " or " : ", ") + name;
    const Node* what = table.optional(name);
    if (!what) continue;
    if (what->type != Node::Type::text || what->text.empty())
      table.mistake(name + " is a name or a path", *what);
    else if (!entry.kind.empty())
      table.mistake("an entry shows one thing: it has a " + entry.kind + " already", *what);
    else
      entry.kind = name, entry.what = what->text, entry.where = what->where;
  }
  const bool slip = std::any_of(node.items.begin(), node.items.end(), [](const Node& n) {
    return n.type == Node::Type::text && n.key != "title" && n.key != "text" && n.key != "alt" && n.key != "schemes";
  });
  if (entry.kind.empty() && !slip) mistakes.add("an entry needs a " + kinds, node.where); // a slip is told by itself
}

void read_values(TableReader& table, Entry& entry, Mistakes& mistakes) {
  entry.vary = table.text("vary", "");
  const Node* values = table.optional("values");
  entry.frames = static_cast<int>(table.number("frames", fewest_frames, most_frames, entry.frames));
  if (!values) return;
  if (values->type != Node::Type::list || values->items.size() < 2 || values->items.size() > render::most_panes)
    return table.mistake("values is a list of 2 to " + std::to_string(render::most_panes), *values);
  for (const Node& n : values->items)
    if (const auto value = value_of(n, mistakes)) entry.values.push_back(*value);
}

std::optional<PictureRequest> read_picture(const Node* node, Mistakes& mistakes) {
  if (!node) return std::nullopt;
  TableReader table(*node, "a picture", mistakes);
  PictureRequest p;
  p.file = table.text("file", "");
  p.at = table.number("at", 0, latest, -1.0);
  p.set = assignments(table.optional("set"), mistakes);
  const bool plain = p.file.find('/') == std::string::npos && !p.file.starts_with(".");
  if (p.file.empty() || !plain) table.mistake("a picture needs a file: a name without folders", *node);
  table.done();
  return p;
}

Entry read_entry(const Node& node, Mistakes& mistakes) {
  TableReader table(node, "an entry", mistakes);
  Entry entry;
  read_what(table, node, entry, mistakes);
  entry.schemes = table.text("schemes", "");
  entry.title = table.text("title", "");
  entry.text = table.text("text", "");
  entry.alt = table.text("alt", "");
  entry.set = assignments(table.optional("set"), mistakes);
  entry.poster = table.number("poster", 0, latest, -1.0);
  entry.fast = read_flag(table, "fast");
  entry.width = table.text("width", "");
  read_values(table, entry, mistakes);
  entry.picture = read_picture(table.optional("picture"), mistakes);
  if (entry.kind == "scrub" && (entry.vary.empty() || !node.find("values")))
    mistakes.add("a scrub needs vary = \"a parameter\" and values = [..., ...]", entry.where);
  table.done();
  return entry;
}

} // namespace

Spec parse_spec(std::string_view text, const std::string& file) {
  const Node root = parse_toml(text, file);
  Mistakes mistakes;
  TableReader table(root, "a gallery", mistakes);
  Spec spec;
  spec.title = table.text("title", spec.title);
  spec.intro = table.text("intro", "");
  spec.all = assignments(table.optional("all"), mistakes);
  const Node* entries = table.optional("entry");
  if (!entries || entries->type != Node::Type::list || entries->items.empty())
    mistakes.add("a gallery has entries: [[entry]] and, for example, study = \"dam_break\"", root.where);
  else
    for (const Node& node : entries->items) {
      if (node.type == Node::Type::table)
        spec.entries.push_back(read_entry(node, mistakes));
      else
        mistakes.add("an entry is written as [[entry]]", node.where);
    }
  table.done();
  mistakes.raise();
  return spec;
}

Spec read_spec(const std::string& file) {
  return parse_spec(read_text_file(file), file);
}

Entry parse_scrub(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.rfind(':', equals);
  if (equals == std::string::npos || colon == std::string::npos || colon == 0 || colon + 1 == equals)
    throw UserError("--scrub " + text +
                    ": it is STUDY:PATH=VALUE,VALUE,..., as in dam_break:transfer.flip_ratio=0,0.5,1");
  Entry entry;
  entry.kind = "scrub";
  entry.what = text.substr(0, colon);
  entry.where = {"--scrub", 0, 0};
  entry.vary = text.substr(colon + 1, equals - colon - 1);
  for (const std::string& value : split_list(text.substr(equals + 1), "--scrub"))
    entry.values.push_back(parse_value(value));
  if (entry.values.size() < 2 || entry.values.size() > render::most_panes)
    throw UserError("--scrub " + text + ": it needs 2 to " + std::to_string(render::most_panes) + " values");
  return entry;
}

} // namespace flipbook::app::gallery
