// SPDX-License-Identifier: MIT
#include "app/series/series.h"

#include "app/series/solid_places.h"
#include "app/study/study.h"
#include "sim/files/write_particles.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_frames = 1'000'000;
constexpr double most_steps = 1e15, most_cells = 1 << 27, longest = 1e6;

/// One list of numbers of a table: `count` of them, each from lo to hi. Long lists are not repeated in a message.
std::vector<double> list_of(TableReader& table, std::string_view key, std::size_t count, double lo, double hi) {
  const Node* node = table.required(key);
  std::vector<double> all;
  if (!node) return std::vector<double>(count, lo);
  bool good = node->type == Node::Type::list && node->items.size() == count;
  for (const Node& n : node->items) {
    good = good && n.type == Node::Type::number && n.number >= lo && n.number <= hi;
    all.push_back(n.number);
  }
  if (good) return all;
  table.mistake("\"" + std::string(key) + "\" must be a list of " + std::to_string(count) + " numbers from " +
                    to_toml(Value(lo)) + " to " + to_toml(Value(hi)),
                *node);
  return std::vector<double>(count, lo);
}

bool flag(TableReader& table, std::string_view key) {
  const Node* node = table.required(key);
  if (node && node->type != Node::Type::flag)
    table.mistake("\"" + std::string(key) + "\" must be true or false", *node);
  return node && node->flag;
}

/// A name without a way out of the folder: no '/', not ".", not "..".
std::string plain_name(TableReader& table, std::string_view key) {
  const Node* node = table.required(key);
  if (!node) return {};
  const std::string& name = node->text;
  const bool plain = node->type == Node::Type::text && !name.empty() && name.front() != '.' &&
                     name.find_first_of(std::string("/\\\0", 3)) == std::string::npos;
  if (!plain) table.mistake("\"" + std::string(key) + "\" must be a name inside the folder of the series", *node);
  return plain ? name : std::string();
}

std::vector<Assignment> assignments(const Node* node, const std::string& prefix, Mistakes& mistakes) {
  std::vector<Assignment> all;
  if (node) flatten(*node, prefix, all, mistakes);
  return all;
}

/// The tables of [[key]].
std::vector<const Node*> tables(const Node* list, const std::string& key, Mistakes& mistakes) {
  std::vector<const Node*> all;
  if (!list) return all;
  for (const Node& n : list->items)
    if (list->type == Node::Type::list && n.type == Node::Type::table) all.push_back(&n);
  if (all.size() != list->items.size() || list->type != Node::Type::list)
    mistakes.add("a " + key + " is written as [[" + key + "]]", list->where);
  return all;
}

class Reader {
public:
  explicit Reader(const fs::path& folder) : folder_(folder), file_((folder / series_index).string()) {}

  Series read() {
    const Node root = parse_toml(read_text_file(file_), file_);
    TableReader table(root, "the series", mistakes_);
    series_.title = table.text("title", "");
    read_format(table);
    series_.fps = table.number("fps", 1, 240, std::nullopt);
    series_.duration = table.number("duration", 0, longest, 0.0);
    read_times(table);
    series_.view = assignments(table.optional("view"), "view", mistakes_);
    const Node* list = table.required("variant");
    for (const Node* node : tables(list, "variant", mistakes_)) read_variant(*node);
    if (list && (series_.variants.empty() || series_.variants.size() > most_variants))
      mistakes_.add("a series has 1 to " + std::to_string(most_variants) + " variants", list->where);
    table.done();
    mistakes_.raise();
    return std::move(series_);
  }

private:
  void read_format(TableReader& table) {
    const Node* node = table.required("format");
    if (!node) return;
    series_.format = node->text;
    std::vector<std::string> known;
    for (const Option& o : particle_format_options()) known.emplace_back(o.name);
    if (node->type != Node::Type::text || std::find(known.begin(), known.end(), node->text) == known.end())
      table.mistake("\"format\" must be \"csv\", \"ply\" or \"vtp\"", *node, nearest_name(node->text, known));
  }

  void read_times(TableReader& table) {
    const Node* node = table.required("times");
    if (!node) return;
    series_.times = list_of(table, "times", std::clamp<std::size_t>(node->items.size(), 1, most_frames), 0, longest);
    for (std::size_t k = 1; k < series_.times.size(); ++k)
      if (!(series_.times[k] > series_.times[k - 1]))
        return table.mistake("\"times\" must increase: frame " + std::to_string(k) + " is at " +
                                 to_toml(Value(series_.times[k])) + " s",
                             *node);
  }

  void read_variant(const Node& node) {
    TableReader table(node, "a variant", mistakes_);
    SeriesVariant v;
    v.folder = plain_name(table, "folder");
    v.label = table.text("label", "");
    v.title = table.text("title", "");
    v.scheme = table.text("scheme", "");
    v.kernel = table.text("kernel", "");
    v.solver = table.text("solver", "");
    if (const Node* notes = table.optional("notes"))
      for (const Node& n : notes->items) v.notes.push_back(n.text);
    v.watermark = table.text("watermark", "");
    v.time_unit = table.text("time_unit", "s");
    read_domain(table, v);
    const std::size_t frames = series_.times.size();
    for (const double n : list_of(table, "steps", frames, 0, most_steps))
      v.steps.push_back(static_cast<std::uint64_t>(n));
    v.dt = list_of(table, "dt", frames, 0, longest);
    v.parameters = assignments(table.optional("parameters"), "", mistakes_);
    for (const Node* change : tables(table.optional("change"), "change", mistakes_)) read_change(*change, v);
    read_solids(table, v);
    table.done();
    series_.variants.push_back(std::move(v));
  }

  void read_domain(TableReader& table, SeriesVariant& v) {
    v.dim = static_cast<int>(table.number("dim", 2, 3, std::nullopt));
    v.single = flag(table, "single");
    const auto dim = static_cast<std::size_t>(v.dim);
    const auto axes = [&](std::string_view key, auto& list, double lo, double hi) {
      const std::vector<double> numbers = list_of(table, key, dim, lo, hi);
      for (std::size_t a = 0; a < dim; ++a) list[a] = static_cast<std::decay_t<decltype(list[a])>>(numbers[a]);
    };
    axes("origin", v.origin, -1e6, 1e6);
    axes("lo", v.lo, -1e6, 1e6);
    axes("size", v.size, 1e-6, 1e6);
    axes("cells", v.cells, 1, 16384);
    double cells = 1;
    for (std::size_t a = 0; a < dim; ++a) cells *= v.cells[a];
    if (const Node* node = table.optional("cells"); node && cells > most_cells)
      table.mistake("the domain has too many cells", *node);
    v.dx = table.number("dx", 1e-9, 1e6, std::nullopt);
    axes("up", v.up, -1, 1);
    if (dim == 2) v.up[2] = 0;
    const auto used = std::count_if(v.up.begin(), v.up.end(), [](double u) { return u != 0; });
    const double length = std::abs(v.up[0]) + std::abs(v.up[1]) + std::abs(v.up[2]);
    if (const Node* node = table.optional("up"); node && mistakes_.none() && (used != 1 || length != 1))
      table.mistake("\"up\" must be the direction of an axis, for example [0, 1, 0]", *node);
    v.particle_spacing = table.number("particle_spacing", 0, 1e6, std::nullopt);
    read_periodic(table, v);
  }

  void read_periodic(TableReader& table, SeriesVariant& v) {
    const Node* node = table.required("periodic");
    if (!node) return;
    const auto dim = static_cast<std::size_t>(v.dim);
    bool good = node->type == Node::Type::list && node->items.size() == dim;
    for (const Node& n : node->items) good = good && n.type == Node::Type::flag;
    if (!good)
      return table.mistake("\"periodic\" must be a list of " + std::to_string(dim) + " times true or false", *node);
    for (std::size_t a = 0; a < dim; ++a) v.periodic[a] = node->items[a].flag;
  }

  void read_change(const Node& node, SeriesVariant& v) {
    SeriesVariant::Change change;
    Node rest = node;
    std::erase_if(rest.items, [](const Node& n) { return n.key == "frame" || n.key == "title"; });
    TableReader table(node, "a change", mistakes_);
    change.frame = static_cast<std::uint64_t>(table.number("frame", 0, static_cast<double>(most_frames), std::nullopt));
    change.title = table.text("title", v.title);
    change.parameters = assignments(&rest, "", mistakes_);
    if (!v.changes.empty() && change.frame <= v.changes.back().frame)
      mistakes_.add("changes must be in the order of their frames", node.where);
    v.changes.push_back(std::move(change));
  }

  void read_solids(TableReader& table, SeriesVariant& v) {
    if (!table.optional("solids") || !flag(table, "solids") || v.folder.empty()) return;
    try {
      v.places = read_solid_places((folder_ / v.folder / series_solids).string(), series_.times.size());
    } catch (const UserError& error) {
      mistakes_.add(error);
    }
  }

  fs::path folder_;
  std::string file_;
  Mistakes mistakes_;
  Series series_;
};

} // namespace

Series read_series(const fs::path& folder) {
  return Reader(folder).read();
}

} // namespace flipbook::app
