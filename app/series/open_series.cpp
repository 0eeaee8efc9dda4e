// SPDX-License-Identifier: MIT
#include "app/series/open_series.h"

#include "app/series/foreign_series.h"
#include "app/study/paths.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

std::string name_of(const std::string& folder) {
  std::error_code none;
  const fs::path whole = fs::absolute(folder, none).lexically_normal();
  return whole.has_filename() ? whole.filename().string() : whole.parent_path().filename().string();
}

template <Described T> void set(T& component, const Assignment& a, Mistakes& mistakes) {
  if (const Refusal r = set_parameter(component, a.path, a.value); !r.message.empty())
    mistakes.add(r.message, a.where, r.nearest);
}

/// The changes that the user asks for; those of a solver come too late.
void apply_changes(const std::vector<Assignment>& changes, Resolved& r, Mistakes& mistakes) {
  std::vector<Assignment> of_view;
  for (const Assignment& a : changes) {
    if (is_view(a.path))
      of_view.push_back(a);
    else if (is_output(a.path) && a.path != "output.particle_format")
      set(r.output, a, mistakes);
    else if (const Refusal unknown = check_path(a.path); !unknown.message.empty())
      mistakes.add(unknown.message, a.where, unknown.nearest);
    else
      mistakes.add(a.path + " cannot change: the particles are read from files, not simulated", a.where);
  }
  change_view(r.view, of_view, mistakes);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& n : names) text.append(text.empty() ? "" : ", ").append(n);
  return text;
}

/// A view of the solver's grid: a mistake if the user wants it, else left out with a warning.
void fit_view(const std::vector<Assignment>& changes, const std::vector<std::string>& known, OpenedSeries& opened,
              Mistakes& mistakes) {
  render::ViewSettings& view = opened.resolved.view;
  const auto wanted = [&](const std::string& path) {
    const auto at = std::find_if(changes.rbegin(), changes.rend(), [&](auto& a) { return a.path == path; });
    return at == changes.rend() ? nullptr : &*at;
  };
  for (const std::string& channel : view.request().channels) {
    if (std::find(known.begin(), known.end(), channel) != known.end()) continue;
    const std::string why = "files of particles have no " + channel;
    if (const Assignment* a = wanted("view.colour")) {
      mistakes.add(why + ", but " + listed(known), a->where);
    } else {
      opened.warnings.push_back(why + ": coloured by speed");
      set(view, {"view.colour", std::string("speed"), {}}, mistakes);
      view.range = {0, 0};
    }
  }
  if (!view.request().faces) return;
  const std::string why = "files of particles have no grid to draw arrows of";
  if (const Assignment* a = wanted("view.arrows"))
    mistakes.add(why, a->where);
  else
    opened.warnings.push_back(why);
  view.arrows = false;
}

std::shared_ptr<const Recording> recording(const fs::path& folder, const Series& s, const SeriesVariant& v,
                                           Mistakes& mistakes) {
  auto r = std::make_shared<Recording>();
  r->variant = v;
  r->times = s.times;
  r->folder = folder / v.folder;
  for (std::size_t k = 0; k < s.times.size(); ++k) {
    r->files.push_back((r->folder / frame_file(k, s.format)).string());
    std::error_code none;
    if (!fs::is_regular_file(r->files.back(), none)) {
      mistakes.add("the series has no file " + r->files.back());
      break;
    }
  }
  return r;
}

void limit_frames(OpenedSeries& opened) {
  const OutputSettings& o = opened.resolved.output;
  std::vector<double>& times = opened.times;
  if (o.duration > 0) std::erase_if(times, [&](double t) { return t >= o.duration; });
  if (o.frames > 0) times.resize(std::min(times.size(), static_cast<std::size_t>(o.frames)));
  if (times.empty()) throw UserError("the series has no frame before " + to_toml(Value(o.duration)) + " s");
}

double fps_of(const std::vector<Assignment>& changes) {
  OutputSettings output;
  Mistakes ignored; // reported with all the others
  for (const Assignment& a : changes)
    if (a.path == "output.fps") set(output, a, ignored);
  return output.fps;
}

} // namespace

bool is_series(const std::string& name) {
  std::error_code none;
  return fs::is_directory(name, none) &&
         (is_path(name) || (!find_asset("studies", name) && !find_asset("scenes", name)));
}

OpenedSeries open_series(const std::string& folder, const std::vector<Assignment>& changes) {
  OpenedSeries opened;
  Mistakes mistakes;
  std::error_code none; // a folder that cannot be read is refused as one without an index
  const bool ours = fs::exists(fs::path(folder) / series_index, none);
  const std::vector<std::string> files = ours ? std::vector<std::string>() : particle_files(folder);
  const Series series = ours ? read_series(folder) : series_of_files(files, fps_of(changes));
  Resolved& r = opened.resolved;
  r.name = name_of(folder);
  r.title = ours ? series.title : r.name;
  r.output.fps = series.fps;
  r.duration = series.duration;
  opened.times = series.times;
  for (const Assignment& a : series.view) set(r.view, a, mistakes);
  std::vector<std::string> channels;
  std::vector<Domain> domains;
  for (const SeriesVariant& v : series.variants) {
    ResolvedVariant variant{v.label, {}, nullptr};
    apply(variant.scene.settings, v.parameters, mistakes);
    if (ours) {
      variant.recording = recording(folder, series, v, mistakes);
    } else {
      auto other = std::make_shared<Recording>();
      *other = {files, series.times, v, folder};
      variant.recording = std::move(other);
    }
    r.variants.push_back(std::move(variant));
    domains.push_back({v.dim, v.size, v.lo});
    if (channels.empty() || v.dim == 2) channels = recorded_channels(v.dim);
  }
  apply_changes(changes, r, mistakes);
  if (const ViewMistake m = check_view(r.view); !m.path.empty()) mistakes.add(m.refusal.message, {}, m.refusal.nearest);
  if (const ArrangementMistake m = check_arrangement(r.view, domains); !m.refusal.message.empty())
    mistakes.add(m.refusal.message);
  fit_view(changes, channels, opened, mistakes);
  mistakes.raise();
  limit_frames(opened);
  r.frames = opened.times.size();
  if (const fs::path study = fs::path(folder) / series_study; ours && fs::is_regular_file(study, none))
    opened.study = read_text_file(study.string());
  return opened;
}

} // namespace flipbook::app
