// SPDX-License-Identifier: MIT
// A figure for a slide: one or two panels of measured series against exact curves, in the colours of the light theme.
// The title is what the figure shows, the caption what was run. Every series is named where it ends, or above its panel
// where it does not reach the right edge. Drawn with Cairo and DejaVu from a file: equal charts give equal bytes.
#pragma once

#include "render/image.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace flipbook::render {

struct ChartAxis {
  std::string label; ///< with the unit
  bool logarithmic = false;
  std::optional<std::array<double, 2>> range{}; ///< otherwise what the series need
  std::vector<double> ticks{};                  ///< otherwise round numbers
  std::vector<std::string> tick_texts{};        ///< of `ticks`, instead of their numbers
  std::vector<std::string> names{};             ///< of the places 0, 1, 2, ... instead of numbers
};

struct ChartSeries {
  enum class Style {
    line,
    dashes,
    points,
    both,  ///< a line with points
    levels ///< a short horizontal line at each point
  };
  enum class Named { automatic, legend }; ///< where it ends if that is at the right edge; always above the panel
  static constexpr int exact = -1;        ///< a colour: that of the text

  std::string label; ///< empty: not named
  int colour = 0;    ///< of a variant, also which shape its points have; or `exact`
  Style style = Style::line;
  std::vector<double> x, y;
  std::vector<double> lo{}, hi{}; ///< ends of the error bars; empty: none
  Named named = Named::automatic;
};

struct ChartPanel {
  std::string title; ///< what is up the axis, with the unit
  ChartAxis x, y;
  std::vector<ChartSeries> series{};
  bool equal_scales = false; ///< a metre to the right is as long as one up
};

struct Chart {
  std::string title, caption;
  std::vector<ChartPanel> panels{};
};

/// 1920 x 1080 pixels. Throws MachineError where there is no DejaVu font.
[[nodiscard]] Image draw_chart(const Chart& chart);

/// Throws MachineError where draw_chart could not draw text.
void check_chart_fonts();

} // namespace flipbook::render
