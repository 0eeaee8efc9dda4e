// SPDX-License-Identifier: MIT
// One step of a run, stage by stage, as its solver took it: nothing is computed a second time.
#pragma once

#include "app/study/resolve.h"
#include "app/validate/case.h"
#include "sim/frame/stage_still.h"

namespace flipbook::app {

/// The step of one variant.
struct RecordedStep {
  std::string title; ///< as its pane is titled
  Settings settings; ///< with the values that its parameters had then
  std::shared_ptr<const Snapshot> before;
  std::vector<StageStill> stills; ///< from `start` to `end`

  [[nodiscard]] double time() const { return stills.front().time; }
  [[nodiscard]] double dt() const { return stills.front().dt; }
};

/// Runs the variants side by side to the time, as a video does, and looks at the step that each takes next. Throws
/// UserError where a solver's stages cannot be seen.
[[nodiscard]] std::vector<RecordedStep> record_steps(const Resolved& study, double time, const Lab& lab);

} // namespace flipbook::app
