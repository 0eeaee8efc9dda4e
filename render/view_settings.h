// SPDX-License-Identifier: MIT
// How a frame is drawn: the parameters below `view.`.
#pragma once

#include "render/compose/arrangement.h"
#include "render/compose/sheet_settings.h"
#include "render/views/look_settings.h"
#include "render/views/plot_settings.h"
#include "render/views/space_settings.h"
#include "sim/frame/parameters.h"
#include "sim/frame/snapshot.h"

#include <array>
#include <string>
#include <vector>

namespace flipbook::render {

enum class Theme { light, dark };
/// The table of the ledger beside or below each pane: none, what changed since the start, or in the last step.
enum class LedgerView { off, total, step };

struct ViewSettings {
  Theme theme = Theme::dark;
  int colour = 0;                       ///< index into the list of colour quantities (render/views/colour_by.h)
  int map = 0;                          ///< index into the list of colour maps; the first, "auto", suits the quantity
  LookSettings look;                    ///< what stands for the particles (render/views/look_settings.h)
  SpaceSettings space;                  ///< what only 3D panes have (render/views/space_settings.h)
  std::array<double, 2> range{0, 0};    ///< of the shared colour scale; equal ends: found from the data
  double particle_size = 1.5;           ///< diameter of a disc in particle spacings; above 1 closes the gaps
  double azimuth = -30, elevation = 20; ///< of the 3D camera, degrees (render/views/camera.h)
  double zoom = 1;                      ///< 1: the whole domain fits its pane
  std::array<double, 3> target{0.5, 0.5, 0.5}; ///< what is in the middle, as fractions of the domain
  bool walls = true, grid = false, arrows = false;
  bool captions = true; ///< dt and steps below each pane
  bool labels = true;   ///< of the timeline's keys, below the title
  bool show_panel = true;
  std::vector<std::string> panel; ///< parameter paths (or last parts) to show; empty: the teach-level ones that apply
  std::vector<std::string> plots{"kinetic", "potential", "total", "transfer_loss"};
  double plot_height = 0.24; ///< share of the frame; 0: no plots
  double time_axis = 0;      ///< length of the plots' time axis (s), until the run outlasts it; 0: that of the run
  PlotSettings plotting;     ///< how the curves are drawn
  LedgerView ledger = LedgerView::off;
  Arrangement arrangement;             ///< of the panes
  SheetSettings sheet;                 ///< of layout = "sheet"
  bool pointer = true, steady = false; ///< of a timeline: the hand on the sliders; the size of a tank that turns

  void describe(ParameterVisitor& v);
  [[nodiscard]] bool is_sheet() const { return arrangement.layout == Placing::sheet; }
  /// What the simulation must publish for these settings.
  [[nodiscard]] FrameRequest request() const;

private:
  void describe_camera(ParameterVisitor& v);
};

} // namespace flipbook::render
