// SPDX-License-Identifier: MIT
#include "sim/scene/read_scene.h"

#include "sim/scene/assets.h"
#include "sim/scene/read_body.h"
#include "sim/scene/read_obstacle.h"
#include "sim/scene/read_particle_source.h"
#include "sim/scene/read_reference.h"
#include "sim/scene/rows_in_domain.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

const std::vector<std::string>& scene_keys() {
  static const std::vector<std::string> keys{"name", "summary",   "reference", "duration",
                                             "body", "particles", "obstacle",  "in_3d"};
  return keys;
}

/// read(entry) for each table of `[[key]]`.
template <class Read>
void each_table(const Node& scene, const std::string& key, const std::string& plural, Mistakes& mistakes, Read&& read) {
  const Node* list = scene.find(key);
  if (!list) return;
  if (list->type != Node::Type::list || list->items.empty())
    return mistakes.add(plural + " are written as [[" + key + "]]", list->where);
  for (const Node& entry : list->items) read(entry);
}

void add_contents(const SceneText& text, Scene& scene, Mistakes& mistakes) {
  const Node& table = text.table;
  SceneFiles& files = *text.files;
  if (!table.find("body") && !table.find("particles"))
    mistakes.add("the scene has no fluid: it needs at least one [[body]] or [[particles]]", table.where);
  each_table(table, "body", "bodies", mistakes, [&](const Node& entry) {
    Body body = read_body(entry, scene.settings, files, mistakes);
    if (body.shape && body.velocity) scene.fluid.push_back(std::move(body));
  });
  each_table(table, "particles", "files of particles", mistakes, [&](const Node& entry) {
    if (auto source = read_particle_source(entry, files, mistakes)) scene.particles.push_back(std::move(*source));
  });
  each_table(table, "obstacle", "obstacles", mistakes, [&](const Node& entry) {
    if (auto obstacle = read_obstacle(entry, scene.domain(), files, mistakes))
      scene.obstacles.push_back(std::move(*obstacle));
  });
}

void check_all_rows(const Scene& scene, Mistakes& mistakes) {
  for (const ParticleSource& source : scene.particles) {
    try {
      check_rows(source, scene.settings);
    } catch (const UserError& error) {
      mistakes.add(error);
    }
  }
}

/// The parameters among the entries of a table, those of the view apart.
std::vector<Assignment> parameters(const Node& table, Scene& scene, Mistakes& mistakes) {
  std::vector<Assignment> all, own;
  for (const Node& entry : table.items) {
    const auto& keys = scene_keys();
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    if (entry.key == "fluid" && entry.type == Node::Type::list) {
      mistakes.add("bodies of fluid are written as [[body]]", entry.where);
      continue;
    }
    flatten(entry, entry.key, all, mistakes);
  }
  for (Assignment& a : all) (a.path.starts_with("view.") ? scene.view : own).push_back(std::move(a));
  return own;
}

/// The last value of `dim` among the assignments.
bool in_space(std::span<const Assignment> all) {
  const auto dim = std::find_if(all.rbegin(), all.rend(), [](const Assignment& a) { return a.path == "dim"; });
  return dim != all.rend() && dim->value == Value(3.0);
}

/// The scene's own parameters; in 3D what `[in_3d]` says comes after, and wins over the rest.
std::vector<Assignment> own_parameters(const Node& table, std::span<const Assignment> changes, Scene& scene,
                                       Mistakes& mistakes) {
  std::vector<Assignment> own = parameters(table, scene, mistakes);
  const Node* space = table.find("in_3d");
  if (!space) return own;
  if (space->type != Node::Type::table) {
    mistakes.add("what differs in 3D is written as a table, [in_3d]", space->where);
    return own;
  }
  std::vector<Assignment> all = own;
  all.insert(all.end(), changes.begin(), changes.end());
  if (!in_space(all)) return own;
  const std::vector<Assignment> more = parameters(*space, scene, mistakes);
  own.insert(own.end(), more.begin(), more.end());
  return own;
}

std::size_t rank(const std::vector<Parameter>& all, const std::string& path) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.path == path; });
  return static_cast<std::size_t>(at - all.begin());
}

/// An axis that is not listed gets cells of the size that the others have.
void complete_cells(Settings& settings, std::span<const Assignment> changes) {
  const auto last = std::find_if(changes.rbegin(), changes.rend(), [](auto& a) { return a.path == "grid.cells"; });
  if (last != changes.rend()) {
    const auto* cells = std::get_if<std::vector<double>>(&last->value);
    if (cells && cells->size() == 3) return;
  }
  const double along_z = settings.grid.size[2] * settings.grid.cells[0] / settings.grid.size[0];
  settings.grid.cells[2] = static_cast<int>(std::clamp(std::round(along_z), 1.0, 16384.0));
}

/// On nodes the linear kernel has to be asked for: forces through its gradient jump where a particle leaves a cell.
void usual_kernel(Settings& settings, std::span<const Assignment> changes) {
  const auto last = [&](std::string_view path) {
    return std::find_if(changes.rbegin(), changes.rend(), [&](const Assignment& a) { return a.path == path; });
  };
  const auto solver = last("solver");
  if (solver != changes.rend() && solver->value == Value("mpm") && last("transfer.kernel") == changes.rend())
    settings.transfer.kernel = KernelName::quadratic;
}

void refuse_conflicts(const Settings& settings, std::span<const Assignment> changes, Mistakes& mistakes) {
  const Settings::Conflict conflict = settings.conflict();
  if (conflict.message.empty()) return;
  const auto at = std::find_if(changes.rbegin(), changes.rend(), [&](auto& a) { return a.path == conflict.path; });
  mistakes.add(conflict.message, at == changes.rend() ? Location{} : at->where);
}

} // namespace

void apply(Settings& settings, std::span<const Assignment> changes, Mistakes& mistakes) {
  usual_kernel(settings, changes);
  const std::vector<Parameter> all = parameters_of(settings);
  std::vector<std::pair<std::size_t, const Assignment*>> ordered;
  for (const Assignment& a : changes) ordered.emplace_back(rank(all, a.path), &a);
  std::stable_sort(ordered.begin(), ordered.end(), [](auto& a, auto& b) { return a.first < b.first; });
  bool fits = true;
  for (const auto& [place, a] : ordered) {
    Refusal refusal = set_parameter(settings, a->path, a->value);
    if (refusal.message.empty()) continue;
    // Without a dot it may also have been meant as one of the scene's own keys.
    if (place == all.size() && a->path.find('.') == std::string::npos)
      if (std::string own = nearest_name(a->path, scene_keys()); !own.empty()) refusal.nearest = std::move(own);
    mistakes.add(refusal.message, a->where, refusal.nearest);
    fits = false;
  }
  complete_cells(settings, changes);
  if (fits) refuse_conflicts(settings, changes, mistakes);
}

SceneText load_scene(const std::string& name_or_path, const std::string& base) {
  const auto path = find_asset("scenes", name_or_path, base);
  if (path) return SceneText{stem(*path), parse_toml(read_text_file(*path), *path)};
  if (is_path(name_or_path)) throw UserError("there is no scene file \"" + name_or_path + "\"");
  throw UserError("there is no scene \"" + name_or_path + "\"", {}, nearest_name(name_or_path, list_scenes()));
}

Scene make_scene(const SceneText& text, std::span<const Assignment> changes, Mistakes& mistakes) {
  Scene scene;
  TableReader reader(text.table, "the scene", mistakes);
  scene.name = reader.text("name", text.name);
  scene.summary = reader.text("summary", "");
  const Node* reference = text.table.find("reference"); // one sentence, or tables of values
  if (reference && reference->type == Node::Type::list)
    scene.references = read_references(*reference, *text.files, mistakes);
  else
    scene.reference = reader.text("reference", "");
  scene.duration = reader.number("duration", 1e-6, 1e6, 2.0);
  std::vector<Assignment> all = own_parameters(text.table, changes, scene, mistakes);
  all.insert(all.end(), changes.begin(), changes.end());
  apply(scene.settings, all, mistakes);
  add_contents(text, scene, mistakes);
  // Told before anything is written. The notes' grid is another one and has its own check.
  if (mistakes.none() && scene.settings.preset == Preset::none) check_all_rows(scene, mistakes);
  return scene;
}

Scene make_scene(const SceneText& text, std::span<const Assignment> changes) {
  Mistakes mistakes;
  Scene scene = make_scene(text, changes, mistakes);
  mistakes.raise();
  return scene;
}

Scene read_scene(const std::string& name_or_path, std::span<const Assignment> changes) {
  return make_scene(load_scene(name_or_path), changes);
}

Scene parse_scene(std::string_view text, const std::string& file, std::span<const Assignment> changes) {
  return make_scene(SceneText{stem(file), parse_toml(text, file)}, changes);
}

std::vector<std::string> list_scenes() {
  return list_assets("scenes");
}

} // namespace flipbook
