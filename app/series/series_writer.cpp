// SPDX-License-Identifier: MIT
#include "app/series/series_writer.h"

#include "app/series/solid_places.h"
#include "app/study/titles.h"
#include "sim/files/surface_ply.h"
#include "sim/files/write_particles.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <set>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

/// What differs from the defaults.
std::vector<Assignment> view_of(render::ViewSettings view) {
  render::ViewSettings standard;
  const std::vector<Parameter> before = parameters_of(standard), now = parameters_of(view);
  std::vector<Assignment> all;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i].value != before[i].value) all.push_back({now[i].path, now[i].value, {}});
  return all;
}

std::vector<Assignment> differences(const std::vector<Parameter>& now, const std::vector<Parameter>& before) {
  std::vector<Assignment> all;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (i >= before.size() || now[i].path != before[i].path || now[i].value != before[i].value)
      all.push_back({now[i].path, now[i].value, {}});
  return all;
}

/// `title` in lower case without what file systems dislike; numbered where another has it.
std::string free_name(const std::string& title, const std::set<std::string>& taken) {
  const std::string name = folder_name(title);
  std::string free = name;
  for (int n = 2; taken.contains(free); ++n) free = name + "_" + std::to_string(n);
  return free;
}

bool same(const StandingSolid& a, const StandingSolid& b) {
  return a.id == b.id && a.pose.rotation == b.pose.rotation && a.pose.shift == b.pose.shift;
}

/// Every file of a series, relative to its folder.
std::set<fs::path> files_of(const Series& s) {
  std::set<fs::path> all{series_index, series_study};
  for (const SeriesVariant& v : s.variants) {
    for (std::size_t k = 0; k < s.times.size(); ++k) all.insert(fs::path(v.folder) / frame_file(k, s.format));
    if (!v.places.empty()) all.insert(fs::path(v.folder) / series_solids);
    for (const SolidPlaces& p : v.places)
      for (const StandingSolid& solid : p.solids) all.insert(fs::path(v.folder) / solid_file(solid.id));
    if (s.format == "vtp") all.insert(v.folder + ".pvd");
  }
  return all;
}

/// The files of the series that is there now; none if there is no readable one.
std::set<fs::path> earlier_files(const fs::path& folder) {
  try {
    return files_of(read_series(folder));
  } catch (const UserError&) {
    return {};
  }
}

/// The index is a text that is read whole, and places are kept in memory until the end.
void refuse_too_long(const Resolved& r) {
  constexpr double number_bytes = 25, change_bytes = 300, most_bytes = 7.5e6, most_places = 2e6;
  const auto frames = static_cast<double>(r.frames), variants = static_cast<double>(r.variants.size());
  double changes = 0, places = 0;
  for (const Command& c : r.commands()) changes += c.variant < 0 ? variants : 1;
  for (const ResolvedVariant& v : r.variants)
    for (const Obstacle& o : v.scene.obstacles) places += o.motion ? frames : 1;
  if (number_bytes * frames * (1 + 2 * variants) + change_bytes * changes <= most_bytes && places <= most_places)
    return;
  throw UserError("--particles: " + std::to_string(r.frames) + " frames of " + std::to_string(r.variants.size()) +
                  " variants" +
                  (places > most_places ? " with moving obstacles"
                   : changes > 0        ? " with keys"
                                        : "") +
                  " are more than a series can hold");
}

[[noreturn]] void in_the_way(const fs::path& file) {
  throw UserError("--particles: \"" + file.string() +
                  "\" is in the way: it does not belong to a series of particles; choose another folder");
}

/// What a series may call a file in the folder of a variant.
bool is_own_name(const std::string& name) {
  return name.starts_with("frame_") || name.starts_with("solid");
}

} // namespace

SeriesWriter::SeriesWriter(fs::path folder, const Resolved& resolved, std::string study)
    : folder_(std::move(folder)), resolved_(resolved), study_(std::move(study)), earlier_(earlier_files(folder_)),
      staging_(folder_), index_(folder_) {
  refuse_too_long(resolved);
  refuse_strangers();
  series_.title = resolved.title;
  series_.format = name_of(resolved.output.particle_format);
  series_.fps = resolved.output.fps;
  series_.duration = resolved.duration;
  series_.view = view_of(resolved.view);
}

void SeriesWriter::refuse_strangers() const {
  std::error_code none;
  for (const char* name : {series_index, series_study})
    if (!earlier_.contains(name) && fs::exists(folder_ / name, none)) in_the_way(folder_ / name);
}

void SeriesWriter::refuse_strangers(const std::string& variant) const {
  std::error_code none;
  if (const std::string pvd = variant + ".pvd"; !earlier_.contains(pvd) && fs::exists(folder_ / pvd, none))
    in_the_way(folder_ / pvd);
  std::set<fs::path> names; // sorted: which one is told does not depend on the file system
  for (fs::directory_iterator at(folder_ / variant, none), end; !none && at != end; at.increment(none))
    names.insert(at->path().filename());
  for (const fs::path& name : names)
    if (is_own_name(name.string()) && !earlier_.contains(fs::path(variant) / name))
      in_the_way(folder_ / variant / name);
}

void SeriesWriter::begin(std::span<const std::shared_ptr<const Snapshot>> variants) {
  std::vector<TitledPane> panes;
  for (std::size_t i = 0; i < variants.size(); ++i)
    panes.push_back({resolved_.variants[i].label, variants[i]->title, variants[i]->parameters});
  const std::vector<std::string> titles = pane_titles(panes);
  std::set<std::string> taken;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const Snapshot& s = *variants[i];
    SeriesVariant v;
    v.folder = *taken.insert(free_name(titles[i], taken)).first;
    v.label = resolved_.variants[i].label;
    v.title = s.title;
    v.scheme = s.scheme;
    v.kernel = s.kernel;
    v.solver = s.solver;
    v.notes = s.notes;
    v.watermark = s.watermark;
    v.time_unit = s.time_unit;
    v.parameters = differences(s.parameters, {});
    v.dim = s.dim;
    v.origin = resolved_.variants[i].scene.settings.grid.origin;
    v.cells = s.cells;
    v.dx = s.dx;
    v.periodic = s.periodic;
    v.up = s.up;
    v.particle_spacing = s.particle_spacing;
    v.lo = s.lo;
    for (std::size_t a = 0; a < 3; ++a) v.size[a] = s.hi[a] - s.lo[a];
    refuse_strangers(v.folder);
    variants_.push_back(std::make_unique<Staging>(folder_ / v.folder));
    series_.variants.push_back(std::move(v));
    last_.push_back(s.parameters);
    surfaces_.emplace_back();
  }
}

void SeriesWriter::note(const Snapshot& s, std::size_t i) {
  SeriesVariant& v = series_.variants[i];
  const std::string& title = v.changes.empty() ? v.title : v.changes.back().title;
  std::vector<Assignment> changed = differences(s.parameters, last_[i]);
  if (!changed.empty() || s.title != title) v.changes.push_back({series_.times.size(), s.title, std::move(changed)});
  last_[i] = s.parameters;
  v.steps.push_back(s.steps);
  v.dt.push_back(s.dt);
  note_solids(s, i);
}

/// Bodies enter and leave: a surface is written when its body is first seen, places when they are others than before.
void SeriesWriter::note_solids(const Snapshot& s, std::size_t i) {
  SeriesVariant& v = series_.variants[i];
  std::vector<StandingSolid> standing;
  for (const Solid& solid : s.solids) {
    standing.push_back({solid.id, solid.pose});
    if (surfaces_[i].insert(solid.id).second)
      variants_[i]->write(solid_file(solid.id), write_surface(*solid.surface, v.origin));
  }
  const bool unchanged = v.places.empty() ? standing.empty()
                                          : std::equal(standing.begin(), standing.end(), v.places.back().solids.begin(),
                                                       v.places.back().solids.end(), same);
  if (!unchanged) v.places.push_back({series_.times.size(), std::move(standing)});
}

void SeriesWriter::write(const Stop& stop, std::span<const std::shared_ptr<const Snapshot>> variants,
                         const std::function<ParticleTable(std::size_t)>& table, Pool& pool) {
  if (variants_.empty()) begin(variants);
  for (std::size_t i = 0; i < variants.size(); ++i) note(*variants[i], i);
  const std::string file = frame_file(series_.times.size(), series_.format);
  std::vector<char> single(variants.size());
  pool.each(static_cast<int>(variants.size()), [&](int i) {
    const auto v = static_cast<std::size_t>(i);
    const ParticleTable t = table(v);
    single[v] = t.single;
    variants_[v]->write(file, write_particles(t, resolved_.output.particle_format));
  });
  for (std::size_t i = 0; i < variants.size(); ++i) series_.variants[i].single = single[i] != 0;
  series_.times.push_back(stop.time);
}

/// The index that ParaView opens as a series in time.
std::string SeriesWriter::collection(const SeriesVariant& v) const {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                     "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t k = 0; k < series_.times.size(); ++k)
    text += "<DataSet timestep=\"" + to_toml(Value(series_.times[k])) + "\" group=\"\" part=\"0\" file=\"" + v.folder +
            "/" + frame_file(k, series_.format) + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

void SeriesWriter::finish() {
  for (std::size_t i = 0; i < variants_.size(); ++i) {
    const SeriesVariant& v = series_.variants[i];
    if (!v.places.empty()) variants_[i]->write(series_solids, to_text(v.places));
    if (series_.format == "vtp") staging_.write(v.folder + ".pvd", collection(v));
  }
  staging_.write(series_study, study_);
  index_.write(series_index, to_toml(series_));
}

void SeriesWriter::commit() {
  const std::set<fs::path> now = files_of(series_);
  // Interrupted from here on, the folder has no index rather than one that describes other files.
  std::error_code ignored;
  fs::remove(folder_ / series_index, ignored);
  for (const auto& v : variants_) v->commit();
  staging_.commit();
  for (const fs::path& file : earlier_)
    if (!now.contains(file)) fs::remove(folder_ / file, ignored);
  for (const fs::path& file : earlier_)
    if (file.has_parent_path()) fs::remove(folder_ / file.parent_path(), ignored); // only where empty
  index_.commit();
}

} // namespace flipbook::app
