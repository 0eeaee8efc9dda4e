// SPDX-License-Identifier: MIT
#include "app/study/resolve.h"

#include "app/study/titles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook::app {
namespace {

template <Described T> void apply_to(T& component, std::span<const Assignment> assignments, Mistakes& mistakes) {
  for (const Assignment& a : assignments)
    if (const Refusal r = set_parameter(component, a.path, a.value); !r.message.empty())
      mistakes.add(r.message, a.where, r.nearest);
}

void resolve_variants(const Study& study, Resolved& resolved, Mistakes& mistakes) {
  for (const Variant& v : study.variants) {
    std::vector<Assignment> changes = study.parameters;
    changes.insert(changes.end(), v.parameters.begin(), v.parameters.end());
    resolved.variants.push_back({v.label, make_scene(study.scene, changes, mistakes)});
  }
  for (const ResolvedVariant& v : resolved.variants)
    if (v.scene.settings.time.scale != resolved.variants.front().scene.settings.time.scale)
      mistakes.add("time.scale must be the same for all variants: they share their frames",
                   study.variants[static_cast<std::size_t>(&v - resolved.variants.data())].where);
}

std::vector<KeyTarget> key_targets(const Resolved& resolved) {
  std::vector<TitledPane> panes;
  for (const ResolvedVariant& v : resolved.variants) {
    Settings settings = v.scene.settings;
    panes.push_back({"", settings.transfer.title(), parameters_of(settings)});
  }
  const std::vector<std::string> titles = pane_titles(panes);
  std::vector<KeyTarget> targets;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const ResolvedVariant& v = resolved.variants[i];
    KeyTarget target{v.scene.settings, {titles[i], panes[i].solver, v.scene.settings.transfer.name()}};
    if (!v.label.empty()) target.names.insert(target.names.begin(), v.label);
    targets.push_back(std::move(target));
  }
  return targets;
}

} // namespace

Resolved resolve(const Study& study) {
  Mistakes mistakes;
  Resolved resolved;
  resolved.name = study.name;
  if (study.variants.empty() || study.variants.size() > most_variants)
    throw UserError("a study has 1 to " + std::to_string(most_variants) + " variants, not " +
                    std::to_string(study.variants.size()));
  resolve_variants(study, resolved, mistakes);
  const Scene& scene = resolved.variants.front().scene;
  resolved.title = study.title.empty() ? scene.summary : study.title;
  apply_to(resolved.view, scene.view, mistakes);
  const int colour_of_scene = resolved.view.colour;
  const auto range_of_scene = std::exchange(resolved.view.range, {0, 0});
  apply_to(resolved.view, study.view, mistakes);
  // The scene's range belongs to the quantity that the scene shows.
  const bool ranged = std::any_of(study.view.begin(), study.view.end(), [](auto& a) { return a.path == "view.range"; });
  if (!ranged && resolved.view.colour == colour_of_scene) resolved.view.range = range_of_scene;
  apply_to(resolved.output, study.output, mistakes);
  mistakes.raise();

  resolved.timeline = Timeline(study.keys, key_targets(resolved), mistakes);
  mistakes.raise();

  resolved.scale = scene.settings.time.scale;
  const double duration = resolved.output.duration > 0 ? resolved.output.duration : scene.duration;
  const double frames = std::round(duration / resolved.scale * resolved.output.fps);
  constexpr double most_frames = 1e6;
  if (resolved.output.frames == 0 && frames > most_frames)
    throw UserError("the run would have " + std::to_string(std::llround(frames)) +
                    " frames; at most 1000000 are supported");
  resolved.frames = resolved.output.frames > 0 ? static_cast<std::uint64_t>(resolved.output.frames)
                                               : static_cast<std::uint64_t>(std::max(frames, 1.0));
  resolved.duration = resolved.time_of(resolved.frames);
  return resolved;
}

} // namespace flipbook::app
