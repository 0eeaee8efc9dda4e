// SPDX-License-Identifier: MIT
// One stage of one variant's step, drawn into a box: cells, walls, solids, particles, and arrows on the actual faces
// (or nodes). Full arrows and the last colours stand for StageScales.
#pragma once

#include "app/stages/lens.h"
#include "render/chart/pen.h"
#include "render/theme.h"

#include <vector>

namespace flipbook::app {

/// Of a cell: an arrow that stands for StageScales::velocity or ::change.
inline constexpr double full_arrow = 0.8;

/// The colours of all pictures of a story.
struct StageColours {
  explicit StageColours(render::Theme theme);
  const render::Palette& palette;
  render::Colour particle, grid, change;                    ///< particles; the grid; what a stage changed
  render::Colour liquid;                                    ///< cells of liquid, faintly
  std::vector<render::Colour> diverging, sequential, kicks; ///< 256 each
};

/// Which picture.
struct StagePicture {
  const RecordedStep& step;
  const StoryStage& stage;
  const render::Window& window;
  const StageScales& scales;
  const ShownParticle& shown;
  const StageColours& colours;
};

void draw_stage(render::Pen& pen, const render::Rect& box, const StagePicture& picture);

/// The whole domain with its liquid (or its particles) and where the window is.
void draw_overview(render::Pen& pen, const render::Rect& box, const StagePicture& picture);

/// A shaft and a head in proportion, `edge` wider on every side; nothing where it is too short to be seen.
void draw_stage_arrow(render::Pen& pen, render::ChartPoint from, render::ChartPoint to, render::Colour colour,
                      double width, double edge = 0);

} // namespace flipbook::app
