// SPDX-License-Identifier: MIT
#include "app/panel/panel.h"

#include <algorithm>

namespace flipbook::app {
namespace {

bool names(std::string_view wanted, std::string_view path) {
  return path == wanted ||
         (path.size() > wanted.size() && path.ends_with(wanted) && path[path.size() - wanted.size() - 1] == '.');
}

std::shared_ptr<const Parameter> find(const std::shared_ptr<const Snapshot>& s, std::string_view path) {
  for (const Parameter& p : s->parameters)
    if (p.path == path) return p.applies ? std::shared_ptr<const Parameter>(s, &p) : nullptr;
  return nullptr;
}

bool is_moved(const render::Frame& frame, std::string_view path) {
  return std::any_of(frame.pointer.begin(), frame.pointer.end(), [&](const auto& t) { return t.path == path; });
}

/// Paths to show: those that `view.panel` names, in its order, or the teach-level ones; and all that the timeline
/// moves.
std::vector<std::string> chosen_paths(const render::Frame& frame, const render::ViewSettings& view) {
  std::vector<std::string> chosen;
  const auto collect = [&](const auto& wanted) {
    for (const render::Pane& pane : frame.panes)
      for (const Parameter& p : pane.snapshot->parameters)
        if (p.applies && wanted(p) && std::find(chosen.begin(), chosen.end(), p.path) == chosen.end())
          chosen.push_back(p.path);
  };
  for (const std::string& name : view.panel) collect([&](const Parameter& p) { return names(name, p.path); });
  if (view.panel.empty())
    collect([&](const Parameter& p) { return p.level == Level::teach || is_moved(frame, p.path); });
  else
    collect([&](const Parameter& p) { return is_moved(frame, p.path); });
  return chosen;
}

/// What the timeline moves of the view and the panel shows: the rows come first, as a reader looks for the hand there.
std::vector<PanelGroup> groups_of_view(const render::Frame& frame, render::ViewSettings view) {
  std::vector<PanelGroup> groups;
  for (Parameter& p : parameters_of(view))
    if (p.applies && is_moved(frame, p.path)) {
      const std::string path = p.path;
      groups.push_back({path, {{std::make_shared<const Parameter>(std::move(p)), -1}}});
    }
  return groups;
}

PanelGroup group_of(const render::Frame& frame, const std::string& path) {
  PanelGroup group{path, {}};
  bool same = true;
  for (std::size_t i = 0; i < frame.panes.size(); ++i) {
    auto p = find(frame.panes[i].snapshot, path);
    if (p == nullptr) {
      same = false;
      continue;
    }
    group.rows.push_back({std::move(p), static_cast<int>(i)});
    same = same && group.rows.back().parameter->value == group.rows.front().parameter->value;
  }
  const bool apart = std::any_of(frame.pointer.begin(), frame.pointer.end(),
                                 [&](const auto& t) { return t.path == path && t.variant >= 0; });
  if (frame.panes.size() == 1 || (same && !apart)) {
    group.rows.resize(1);
    group.rows[0].variant = -1;
  }
  return group;
}

} // namespace

std::vector<PanelGroup> panel_groups(const render::Frame& frame, const render::ViewSettings& view) {
  std::vector<PanelGroup> groups = groups_of_view(frame, view);
  for (const std::string& path : chosen_paths(frame, view)) groups.push_back(group_of(frame, path));
  // A short panel leaves out what comes last: first what the timeline moves, then what differs between the panes.
  const auto rank = [&](const PanelGroup& g) { return is_moved(frame, g.path) ? 0 : g.rows[0].variant >= 0 ? 1 : 2; };
  std::stable_sort(groups.begin(), groups.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return groups;
}

} // namespace flipbook::app
