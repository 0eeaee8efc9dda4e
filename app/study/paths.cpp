// SPDX-License-Identifier: MIT
#include "app/study/paths.h"

#include "app/study/output_settings.h"
#include "render/views/plot_names.h"
#include "sim/frame/errors.h"
#include "sim/scene/settings.h"

#include <algorithm>

namespace flipbook::app {
namespace {

template <Described T> void add_parameters(std::vector<Parameter>& all) {
  T component;
  for (Parameter& p : parameters_of(component)) all.push_back(std::move(p));
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Does `wanted` name the parameter, by its path or its last parts?
bool names(const std::string& wanted, const std::string& path) {
  return path == wanted || path.ends_with("." + wanted);
}

Refusal check_panel(const std::vector<std::string>& panel) {
  std::vector<Parameter> solver; // only what a solver has can be shown
  add_parameters<Settings>(solver);
  std::vector<std::string> shown;
  for (const Parameter& p : solver) shown.push_back(p.path);
  for (const std::string& wanted : panel)
    if (std::none_of(shown.begin(), shown.end(), [&](const std::string& path) { return names(wanted, path); }))
      return {"view.panel: no parameter is called \"" + wanted + "\"", nearest_name(wanted, shown)};
  return {};
}

Refusal check_plots(const std::string& path, const std::vector<std::string>& plots) {
  for (const std::string& wanted : plots)
    if (Refusal r = check_plot(wanted); !r.message.empty()) return {path + ": " + r.message, r.nearest};
  return {};
}

/// A curve of its own, none that stands for several.
Refusal check_sparkline(const std::string& name) {
  if (name.empty()) return {};
  if (name == render::lost_by_stage) return {"view.sparkline: \"" + name + "\" stands for several curves", ""};
  const Refusal r = check_plot(name);
  return r.message.empty() ? Refusal{} : Refusal{"view.sparkline: " + r.message, r.nearest};
}

} // namespace

std::vector<Parameter> known_parameters() {
  std::vector<Parameter> all;
  add_parameters<Settings>(all);
  add_parameters<render::ViewSettings>(all);
  add_parameters<OutputSettings>(all);
  return all;
}

const std::vector<std::string>& known_paths() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> paths;
    for (const Parameter& p : known_parameters()) paths.push_back(p.path);
    return paths;
  }();
  return all;
}

bool is_view(std::string_view path) {
  return path.starts_with("view.");
}

bool is_output(std::string_view path) {
  return path.starts_with("output.");
}

Refusal check_path(const std::string& path, std::span<const std::string> own) {
  const std::vector<std::string>& all = known_paths();
  if (contains(all, path)) return {};
  const auto inside =
      std::find_if(all.begin(), all.end(), [&](const std::string& known) { return known.starts_with(path + "."); });
  if (inside != all.end() && !path.empty())
    return {"\"" + path + "\" is a group of parameters and has no value of its own, but " + *inside + " has", ""};
  std::string nearest = path.find('.') == std::string::npos ? nearest_name(path, own) : "";
  if (nearest.empty()) nearest = nearest_name(path, all);
  return {"unknown parameter \"" + path + "\"", std::move(nearest)};
}

Refusal check_pane_path(const std::string& path, std::span<const std::string> own) {
  if (Refusal r = check_path(path, own); !r.message.empty()) return r;
  if (is_view(path)) return {"the panes share the view: " + path + " cannot differ between them", ""};
  if (is_output(path)) return {"the panes share the output: " + path + " cannot differ between them", ""};
  return {};
}

const std::vector<std::string>& plot_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const render::PlotName& p : render::plot_names()) names.emplace_back(p.name);
    names.emplace_back(render::lost_by_stage);
    return names;
  }();
  return all;
}

Refusal check_plot(const std::string& name) {
  if (contains(plot_names(), name)) return {};
  return {"no curve is called \"" + name + "\"", nearest_name(name, plot_names())};
}

ViewMistake check_view(const render::ViewSettings& view) {
  if (Refusal r = check_panel(view.panel); !r.message.empty()) return {"view.panel", std::move(r)};
  if (Refusal r = check_plots("view.plots", view.plots); !r.message.empty()) return {"view.plots", std::move(r)};
  if (Refusal r = check_plots("view.log", view.plotting.log); !r.message.empty()) return {"view.log", std::move(r)};
  if (Refusal r = check_sparkline(view.sheet.sparkline); !r.message.empty()) return {"view.sparkline", std::move(r)};
  if (view.range[0] > view.range[1])
    return {"view.range",
            {"view.range must go from the lower end to the upper one, not from " + to_toml(Value(view.range[0])) +
                 " to " + to_toml(Value(view.range[1])),
             ""}};
  return {};
}

} // namespace flipbook::app
