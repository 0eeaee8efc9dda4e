// SPDX-License-Identifier: MIT
#include "render/views/plot_settings.h"

#include "render/views/plot_names.h"

#include <algorithm>

namespace flipbook::render {

void PlotSettings::describe(ParameterVisitor& v) {
  v.names({.name = "log",
           .help = "Plots with a logarithmic axis of values, by name; values of 0 and below have no place there."},
          log);
  v.flag({.name = "shared_axes", .help = "Plots of quantities in the same unit share the range of their axes."},
         shared_axes);
  v.flag({.name = "end_values", .help = "Write the last value beside the end of each curve, where there is room."},
         end_values);
  v.flag({.name = "references", .help = "Draw the reference curves and measured points that the study or scene names."},
         references);
}

bool PlotSettings::is_logarithmic(std::string_view plot) const {
  const bool of_stage = plot.starts_with("lost_");
  return std::any_of(log.begin(), log.end(),
                     [&](const std::string& name) { return name == plot || (of_stage && name == lost_by_stage); });
}

} // namespace flipbook::render
