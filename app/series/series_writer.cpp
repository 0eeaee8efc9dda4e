// SPDX-License-Identifier: MIT
#include "app/series/series_writer.h"

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

bool same(const Pose& a, const Pose& b) {
  return a.rotation == b.rotation && a.shift == b.shift;
}

/// Every file of a series, relative to its folder.
std::set<fs::path> files_of(const Series& s) {
  std::set<fs::path> all{series_index, "study.toml"};
  for (const SeriesVariant& v : s.variants) {
    for (std::size_t k = 0; k < s.times.size(); ++k) all.insert(fs::path(v.folder) / frame_file(k, s.format));
    for (const SeriesSolid& solid : v.solids) all.insert(fs::path(v.folder) / solid.file);
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

std::span<const std::uint8_t> bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

} // namespace

SeriesWriter::SeriesWriter(fs::path folder, const Resolved& resolved, std::string study)
    : folder_(std::move(folder)), resolved_(resolved), study_(std::move(study)), staging_(folder_) {
  constexpr double most_numbers = 200'000; // the index is a text that is read whole
  if (static_cast<double>(resolved.frames) * (1 + 2 * static_cast<double>(resolved.variants.size())) > most_numbers)
    throw UserError("--particles: " + std::to_string(resolved.frames) + " frames of " +
                    std::to_string(resolved.variants.size()) + " variants are more than a series can hold");
  series_.title = resolved.title;
  series_.format = name_of(resolved.output.particle_format);
  series_.fps = resolved.output.fps;
  series_.duration = resolved.duration;
  series_.view = view_of(resolved.view);
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
    variants_.push_back(std::make_unique<Staging>(folder_ / v.folder));
    write_surfaces(s, v, *variants_.back());
    series_.variants.push_back(std::move(v));
    last_.push_back(s.parameters);
  }
}

void SeriesWriter::write_surfaces(const Snapshot& s, SeriesVariant& v, const Staging& staging) const {
  for (const Solid& solid : s.solids) {
    v.solids.push_back({"solid_" + std::to_string(v.solids.size() + 1) + ".ply", {}});
    staging.write(v.solids.back().file, bytes(write_surface(*solid.surface, v.origin)));
  }
}

void SeriesWriter::note(const Snapshot& s, SeriesVariant& v) {
  std::vector<Parameter>& last = last_[static_cast<std::size_t>(&v - series_.variants.data())];
  const std::string& title = v.changes.empty() ? v.title : v.changes.back().title;
  std::vector<Assignment> changed = differences(s.parameters, last);
  if (!changed.empty() || s.title != title) v.changes.push_back({series_.times.size(), s.title, std::move(changed)});
  last = s.parameters;
  v.steps.push_back(s.steps);
  v.dt.push_back(s.dt);
  for (std::size_t i = 0; i < v.solids.size(); ++i) v.solids[i].poses.push_back(s.solids[i].pose);
}

void SeriesWriter::write(const Stop& stop, std::span<const std::shared_ptr<const Snapshot>> variants,
                         const std::function<ParticleTable(std::size_t)>& table, Pool& pool) {
  if (variants_.empty()) begin(variants);
  for (std::size_t i = 0; i < variants.size(); ++i) note(*variants[i], series_.variants[i]);
  const std::string file = frame_file(series_.times.size(), series_.format);
  std::vector<char> single(variants.size());
  pool.each(static_cast<int>(variants.size()), [&](int i) {
    const auto v = static_cast<std::size_t>(i);
    const ParticleTable t = table(v);
    single[v] = t.single;
    variants_[v]->write(file, bytes(write_particles(t, resolved_.output.particle_format)));
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
  for (SeriesVariant& v : series_.variants) {
    for (SeriesSolid& s : v.solids)
      if (std::all_of(s.poses.begin(), s.poses.end(), [&](const Pose& p) { return same(p, s.poses.front()); }))
        s.poses.resize(1);
    if (series_.format == "vtp") staging_.write(v.folder + ".pvd", bytes(collection(v)));
  }
  staging_.write("study.toml", bytes(study_));
  staging_.write(series_index, bytes(to_toml(series_)));
}

void SeriesWriter::commit() {
  const std::set<fs::path> earlier = earlier_files(folder_), now = files_of(series_);
  for (const auto& v : variants_) v->commit();
  staging_.commit();
  std::error_code ignored;
  for (const fs::path& file : earlier)
    if (!now.contains(file)) fs::remove(folder_ / file, ignored);
  for (const fs::path& file : earlier)
    if (file.has_parent_path()) fs::remove(folder_ / file.parent_path(), ignored); // only where empty
}

} // namespace flipbook::app
