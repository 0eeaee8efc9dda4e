// SPDX-License-Identifier: MIT
// The curves that view.plots can name, and what stands above their plots.
#pragma once

#include <span>
#include <string_view>

namespace flipbook::render {

struct PlotName {
  std::string_view name;         ///< of the history's column
  std::string_view label, brief; ///< above the plot, and where there is little room
};
/// All of them. A column of any other name can be plotted too, under its own name.
[[nodiscard]] std::span<const PlotName> plot_names();
/// The entry of a column; without labels where it is not in the list.
[[nodiscard]] PlotName plot_name(std::string_view column);

/// Stands for what each stage took of the kinetic energy: a plot for each stage of the run.
inline constexpr std::string_view lost_by_stage = "lost";

} // namespace flipbook::render
