// SPDX-License-Identifier: MIT
// Curves over time made by hand, for plots.
#pragma once

#include "render/frame.h"

#include <functional>
#include <string>
#include <vector>

namespace flipbook::test {

struct MadeCurve {
  std::string name, unit;
  std::function<double(std::size_t pane, double t)> y; ///< NaN: a gap
};

/// dam_frame() with these curves at 121 times from 0 to the frame's, and nothing else.
[[nodiscard]] render::Frame curves_frame(std::size_t panes, const std::vector<MadeCurve>& curves, double until = 0.55);

/// The same panes without their particles, for pictures that are about the plots.
[[nodiscard]] render::Frame emptied(render::Frame frame);

/// Energies of a pendulum that loses a little, in every pane at another rate, and what it lost.
[[nodiscard]] std::vector<MadeCurve> energies();

/// Points of an experiment and a line beside them.
void add_references(render::Frame& frame, const std::string& plot);

} // namespace flipbook::test
