// SPDX-License-Identifier: MIT
#include "app/session/compose.h"

#include "app/series/playback.h"
#include "app/study/sheet_names.h"
#include "app/study/titles.h"

#include <algorithm>
#include <span>

namespace flipbook::app {
namespace {

/// What a pane with a mistake on purpose says, simulated now or earlier; empty in a normal run.
std::string mistake_in(const Resolved& resolved) {
  for (const ResolvedVariant& v : resolved.variants) {
    if (v.mistake) return v.mistake->watermark;
    if (v.recording && !v.recording->variant.watermark.empty()) return v.recording->variant.watermark;
  }
  return "";
}

/// How far the plots' time axis goes. A run that outlasts one that was given gets twice its length, so that the curves
/// do not shrink with every picture.
double time_axis(const Resolved& resolved, const render::ViewSettings& view, double time) {
  double axis = view.time_axis;
  if (axis <= 0) return resolved.duration;
  while (axis < time) axis *= 2;
  return axis;
}

} // namespace

render::Frame compose(const Resolved& resolved, const Bundle& bundle, std::vector<std::string> warnings) {
  render::Frame frame;
  frame.title = resolved.title;
  frame.time = bundle.stop.time;
  frame.duration = time_axis(resolved, bundle.view, frame.time);
  std::vector<TitledPane> panes;
  for (std::size_t i = 0; i < bundle.snapshots.size(); ++i)
    panes.push_back({resolved.variants[i].label, bundle.snapshots[i]->title, bundle.snapshots[i]->parameters});
  const std::vector<std::string> titles = pane_titles(panes);
  for (std::size_t i = 0; i < titles.size(); ++i) frame.panes.push_back({titles[i], bundle.snapshots[i]});
  if (bundle.view.is_sheet()) {
    MarginNames names = margin_names(panes, bundle.view.sheet.columns_of(panes.size()));
    frame.sheet = {std::move(names.rows), std::move(names.columns)};
  }
  const Timeline& timeline = resolved.timeline;
  if (bundle.view.pointer) frame.pointer = timeline.pointer_targets(bundle.stop.time, resolved.scale);
  frame.labelled = bundle.view.labels && timeline.has_labels();
  if (frame.labelled) frame.label = timeline.label(bundle.stop.time);
  frame.turning = bundle.view.steady || timeline.moves("view.azimuth") || timeline.moves("view.elevation");
  frame.difference = bundle.difference;
  frame.warnings = std::move(warnings);
  frame.references = resolved.references;
  return frame;
}

std::shared_ptr<const RunProvenance> describe_run(const Resolved& resolved, const std::string& study) {
  auto run = std::make_shared<RunProvenance>();
  run->study = study;
  run->mistake = mistake_in(resolved);
  const auto seed = [](const ResolvedVariant& v) { return v.scene.settings.seeding.seed; };
  const auto& all = resolved.variants;
  const auto unknown = [](const ResolvedVariant& v) { return v.recording && v.recording->variant.parameters.empty(); };
  if (std::any_of(all.begin(), all.end(), unknown)) return run; // particles of another program
  const bool same = std::all_of(all.begin(), all.end(), [&](auto& v) { return seed(v) == seed(all.front()); });
  for (const ResolvedVariant& v : std::span(all).first(same ? 1 : all.size()))
    run->seeds += (run->seeds.empty() ? "" : ", ") + std::to_string(seed(v));
  return run;
}

Provenance provenance_of(std::shared_ptr<const RunProvenance> run, const Stop& stop, const render::Frame& frame) {
  Provenance p{std::move(run), stop.frame, stop.time, {}};
  for (const render::Pane& pane : frame.panes) p.variants += (&pane == frame.panes.data() ? "" : "\n") + pane.title;
  return p;
}

} // namespace flipbook::app
