// SPDX-License-Identifier: MIT
// What a picture cannot show of what its settings ask for: lines for the footer.
#pragma once

#include "render/frame.h"
#include "render/view_settings.h"

#include <string>
#include <vector>

namespace flipbook::render {

[[nodiscard]] bool has_panes_of(const Frame& frame, int dim);
/// Is the liquid drawn as one body of one colour, which no scale explains?
[[nodiscard]] bool one_colour(const Frame& frame, const ViewSettings& view);
/// `values`: the result of colour_values for each pane.
[[nodiscard]] std::vector<std::string> what_is_missing(const Frame& frame, const ViewSettings& view,
                                                       const std::vector<std::vector<float>>& values);

} // namespace flipbook::render
