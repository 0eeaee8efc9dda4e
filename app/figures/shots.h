// SPDX-License-Identifier: MIT
// A study looked at at a few times: the snapshots of all its variants, which run side by side in shared steps as they
// do for a video.
#pragma once

#include "app/study/resolve.h"
#include "app/validate/case.h"
#include "render/view_settings.h"

namespace flipbook::app {

struct Shots {
  std::vector<std::string> titles;                              ///< of the variants, as panes are titled
  std::vector<std::vector<std::shared_ptr<const Snapshot>>> at; ///< of each variant, at each time
};

/// `times` ascend and differ. The study's timeline acts as in a video.
[[nodiscard]] Shots take_shots(const Resolved& study, const std::vector<double>& times, const Lab& lab);

/// The view with a range of colours that serves all of them; where it says one, that.
[[nodiscard]] render::ViewSettings with_shared_range(render::ViewSettings view, const Shots& shots);

} // namespace flipbook::app
