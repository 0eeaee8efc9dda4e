// SPDX-License-Identifier: MIT
// The panel in the picture, generated from what the solvers describe: sliders for numbers with a range, boxes for
// choices, check boxes for flags. A parameter that all panes share has one row; one that differs between the panes, or
// that the timeline moves in one of them, has a row for each pane that has it, in that pane's colour.
#pragma once

#include "render/renderer.h"

#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

/// One line of the panel.
struct PanelRow {
  std::shared_ptr<const Parameter> parameter; ///< of a snapshot, which it keeps, or of the view
  int variant;                                ///< -1: all panes
};

/// The rows of one parameter: one that stands for all panes, or one for each pane that has it.
struct PanelGroup {
  std::string path;
  std::vector<PanelRow> rows;
};

/// What the panel shows, in order: what the timeline moves, what differs between the panes, what they share.
[[nodiscard]] std::vector<PanelGroup> panel_groups(const render::Frame& frame, const render::ViewSettings& view);

[[nodiscard]] render::PanelBuilder make_panel();

} // namespace flipbook::app
