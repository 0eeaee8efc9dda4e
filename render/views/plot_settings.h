// SPDX-License-Identifier: MIT
// How the curves over time are drawn: parameters below `view.`.
#pragma once

#include "sim/frame/parameters.h"

#include <string>
#include <string_view>
#include <vector>

namespace flipbook::render {

struct PlotSettings {
  std::vector<std::string> log; ///< plots with a logarithmic value axis
  bool shared_axes = false;     ///< one range for all plots of the same unit
  bool end_values = true;       ///< the last value beside the end of each curve
  bool references = true;       ///< curves and measured points of others, where the study names some

  void describe(ParameterVisitor& v);
  /// "lost" in the list stands for the plots of all stages.
  [[nodiscard]] bool is_logarithmic(std::string_view plot) const;
};

} // namespace flipbook::render
