// SPDX-License-Identifier: MIT
// A study looked at at a few times: the snapshots of all its variants, which run side by side in shared steps as they
// do for a video.
#pragma once

#include "app/session/schedule.h"
#include "app/session/stepper.h"
#include "app/study/resolve.h"
#include "app/validate/case.h"
#include "render/view_settings.h"

#include <functional>

namespace flipbook::app {

struct Shots {
  std::vector<std::string> titles;                              ///< of the variants, as panes are titled
  std::vector<std::vector<std::shared_ptr<const Snapshot>>> at; ///< of each variant, at each time
};

/// Steps the variants to each of the times, which ascend and differ, and looks there. The study's timeline and its
/// edits act as in a video.
void visit(const Resolved& study, const std::vector<double>& times, Stepper& variants,
           const std::function<void(const Stop&)>& look);

/// `times` ascend and differ. The study's timeline acts as in a video.
[[nodiscard]] Shots take_shots(const Resolved& study, const std::vector<double>& times, const Lab& lab);

/// The view with a range of colours that serves all of them; where it says one, that.
[[nodiscard]] render::ViewSettings with_shared_range(render::ViewSettings view, const Shots& shots);

} // namespace flipbook::app
