// SPDX-License-Identifier: MIT
// The last value of each curve beside its end. Where two would touch they move apart, and a thin line leads from the
// dot to its number.
#pragma once

#include "render/gui/ink.h"
#include "render/theme.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

struct EndValue {
  gui::Point dot; ///< the end of the curve
  std::string text;
  std::size_t pane = 0;
};

/// The places nearest to `wanted` (rising), by the sum of squares, that are `gap` apart and in [lo, hi]. There must be
/// room: (n - 1) gap <= hi - lo.
[[nodiscard]] std::vector<float> apart(std::span<const float> wanted, float gap, float lo, float hi);

/// Pixels from one number to the next below it.
[[nodiscard]] float end_value_gap(const gui::Ink& ink);
/// Pixels on the right of a dot that a number of this width takes.
[[nodiscard]] float end_value_room(const gui::Ink& ink, float width);
/// Draws them on the right of their dots, inside `area` from top to bottom.
void draw_end_values(gui::Ink& ink, std::vector<EndValue> values, const Rect& area, const Palette& palette);

} // namespace flipbook::render
