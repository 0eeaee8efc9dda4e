// SPDX-License-Identifier: MIT
// Curves over time, one for each pane in the colour of its frame, over the values of others where there are some.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/plot_names.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

/// One quantity in all the panes that recorded it.
struct Plot {
  struct Curve {
    std::size_t pane; ///< or no_pane
    const std::vector<float>*t, *y;
  };
  struct Reference {
    const ReferenceCurve* curve;
    std::size_t number; ///< of its label among those of the picture: decides how it looks
  };
  std::string name, unit;
  bool logarithmic = false;
  std::vector<Curve> curves{};
  std::vector<Reference> references{};
};

/// The plots that the settings ask for and that exist.
[[nodiscard]] std::vector<Plot> plots_of(const Frame& frame, const ViewSettings& view);
/// Draws each plot in its box. All keep the same room for their labels, so that axes one below the other line up.
void draw_plots(gui::Ink& ink, std::span<const Rect> boxes, std::span<const Plot> plots, const Frame& frame,
                const PlotSettings& settings, const Palette& palette);

} // namespace flipbook::render
