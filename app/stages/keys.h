// SPDX-License-Identifier: MIT
// What the signs in pictures of stages stand for: an arrow of a cell's length, the ends of a colour, a disc, a ring.
#pragma once

#include "app/stages/painter.h"

#include <functional>
#include <string>
#include <vector>

namespace flipbook::app {

struct StageKey {
  std::string text;
  double width;                                               ///< of the sign
  std::function<void(render::Pen&, render::ChartPoint)> draw; ///< from the middle of its left edge
};

/// Those of one picture. `cell`: length of a cell's edge on the page; `nodes`: is the velocity on nodes?
[[nodiscard]] std::vector<StageKey> keys_of(StageKind kind, const StageScales& scales, const StageColours& colours,
                                            double cell, bool nodes);

/// All that a story needs, each once.
[[nodiscard]] std::vector<StageKey> keys_of(const std::vector<StoryStage>& story, const StageScales& scales,
                                            const StageColours& colours, double cell, bool nodes);

/// One below the other in a column of this width; returns where they end.
double draw_keys_below(render::Pen& pen, render::ChartPoint from, double width, const std::vector<StageKey>& keys,
                       const render::Palette& palette, double size);
/// Side by side, in rows of at most this width; returns where they end.
double draw_keys_beside(render::Pen& pen, render::ChartPoint from, double width, const std::vector<StageKey>& keys,
                        const render::Palette& palette, double size);

} // namespace flipbook::app
