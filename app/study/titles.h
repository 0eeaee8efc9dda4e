// SPDX-License-Identifier: MIT
// What stands above a pane: the title of the solver that ran there, then whatever else differs between the panes.
#pragma once

#include "sim/frame/parameters.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

struct TitledPane {
  std::string label;                 ///< replaces everything if it is not empty
  std::string solver;                ///< "FLIP 0.97"
  std::vector<Parameter> parameters; ///< of a snapshot, or of settings
};

/// "APIC, quadratic", "FLIP 0.97, 128 x 128 cells, cfl 0.25"
[[nodiscard]] std::vector<std::string> pane_titles(std::span<const TitledPane> panes);

/// What is said of one parameter: "CFL 0.25", "128 x 128 cells".
[[nodiscard]] std::string parameter_words(const TitledPane& pane, const Parameter& parameter);

} // namespace flipbook::app
