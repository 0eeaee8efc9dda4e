// SPDX-License-Identifier: MIT
#include "app/figures/shots.h"

#include "app/session/apply_command.h"
#include "app/session/make_variants.h"
#include "app/study/paths.h"
#include "app/study/titles.h"
#include "render/views/colour_by.h"

namespace flipbook::app {

void visit(const Resolved& study, const std::vector<double>& times, Stepper& variants,
           const std::function<void(const Stop&)>& look) {
  Schedule schedule = Schedule::stills(study.output.fps, study.scale, times);
  const CommandLog commands = study.timeline.commands(study.output.fps, study.scale, schedule.boundaries());
  std::size_t next = 0, edit = 0;
  while (const auto stop = schedule.next()) {
    variants.advance_to(stop->time, [] { return false; });
    for (; stop->boundary && next < commands.size() && commands[next].frame <= stop->frame; ++next)
      must_apply(commands[next], variants, "timeline: ");
    for (; stop->boundary && edit < study.edits.size() && study.edits[edit].frame <= stop->frame; ++edit) {
      const auto* change = std::get_if<SetParameter>(&study.edits[edit].action);
      if (!change || !is_view(change->path)) must_apply(study.edits[edit], variants, "an edit: ");
    }
    if (stop->shown) look(*stop);
  }
}

Shots take_shots(const Resolved& study, const std::vector<double>& times, const Lab& lab) {
  const std::unique_ptr<Stepper> variants = make_variants(study, lab.pool);
  Stepper& stepper = *variants;
  Shots shots;
  shots.at.resize(stepper.size());
  std::size_t done = 0;
  visit(study, times, stepper, [&](const Stop& stop) {
    lab.pool.each(static_cast<int>(stepper.size()), [&](int i) {
      const auto v = static_cast<std::size_t>(i);
      shots.at[v].push_back(stepper[v].snapshot(stop.frame, study.request()));
    });
    lab.progress(++done, times.size());
  });
  std::vector<TitledPane> panes;
  for (std::size_t v = 0; v < stepper.size(); ++v)
    panes.push_back({study.variants[v].label, stepper[v].title(), stepper[v].parameters()});
  shots.titles = pane_titles(panes);
  return shots;
}

render::ViewSettings with_shared_range(render::ViewSettings view, const Shots& shots) {
  if (view.range[0] != view.range[1]) return view;
  render::Frame all;
  std::vector<std::vector<float>> values;
  for (const auto& variant : shots.at)
    for (const auto& s : variant) {
      all.panes.push_back({"", s});
      values.push_back(colour_values(*s, chosen_quantity(view)));
    }
  const render::ColourScale scale = shared_scale(all, view, values);
  view.range = {scale.lo, scale.hi};
  return view;
}

} // namespace flipbook::app
