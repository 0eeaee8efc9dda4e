// SPDX-License-Identifier: MIT
#include "app/stages/record.h"

#include "app/figures/shots.h"
#include "app/session/make_variants.h"
#include "app/study/titles.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace flipbook::app {

namespace {

/// Keeps the stills of the first step that it sees.
class FirstStep final : public StageTap {
public:
  void saw(StageStill still) override {
    if (done_) return;
    const bool last = still.stage == StageStill::end;
    stills.push_back(std::move(still));
    if (last) done_ = true;
  }
  /// Other variants may be in the middle of theirs.
  [[nodiscard]] bool done() const { return done_; }
  std::vector<StageStill> stills;

private:
  std::atomic<bool> done_{false};
};

/// The first frame after a time: until there the run shares its steps out.
double next_frame(const Resolved& study, double time) {
  auto k = static_cast<std::uint64_t>(time / study.scale * study.output.fps);
  constexpr double rounding = 1e-9; // of a frame: no time for a step
  while (study.time_of(k) <= time + rounding * study.scale / study.output.fps) ++k;
  return study.time_of(k);
}

/// The settings with the values that the parameters have now.
Settings present(Settings settings, const Simulation& simulation) {
  for (const Parameter& p : simulation.parameters()) (void)set_parameter(settings, p.path, p.value);
  return settings;
}

std::vector<RecordedStep> as_they_are(const Resolved& study, Stepper& variants, std::uint64_t frame) {
  std::vector<RecordedStep> steps;
  std::vector<TitledPane> panes;
  FrameRequest request;
  request.phi = true;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const Simulation& s = variants[v];
    panes.push_back({study.variants[v].label, s.title(), s.parameters()});
    steps.push_back({"", present(study.variants[v].scene.settings, s), variants[v].snapshot(frame, request), {}});
  }
  const std::vector<std::string> titles = pane_titles(panes);
  for (std::size_t v = 0; v < steps.size(); ++v) steps[v].title = titles[v];
  return steps;
}

} // namespace

std::vector<RecordedStep> record_steps(const Resolved& study, double time, const Lab& lab) {
  const std::unique_ptr<Stepper> variants = make_variants(study, lab.pool);
  std::vector<FirstStep> taps(variants->size());
  for (std::size_t v = 0; v < taps.size(); ++v) {
    if (!(*variants)[v].watch(&taps[v]))
      throw UserError((*variants)[v].title() + ": the stages of its steps cannot be seen: it is played from files, or "
                                               "runs the notes' own program (preset = \"tutorial\")");
    (void)(*variants)[v].watch(nullptr);
  }
  std::vector<RecordedStep> steps;
  visit(study, {time}, *variants, [&](const Stop& stop) { steps = as_they_are(study, *variants, stop.frame); });
  for (std::size_t v = 0; v < taps.size(); ++v) (void)(*variants)[v].watch(&taps[v]);
  const auto all_done = [&] { return std::all_of(taps.begin(), taps.end(), [](auto& t) { return t.done(); }); };
  // Steps of a fixed length may be longer than it is to the next frame.
  for (double to = time; !all_done();) variants->advance_to(to = next_frame(study, to), all_done);
  for (std::size_t v = 0; v < taps.size(); ++v) {
    (void)(*variants)[v].watch(nullptr);
    steps[v].stills = std::move(taps[v].stills);
  }
  return steps;
}

} // namespace flipbook::app
