// SPDX-License-Identifier: MIT
// Which pane stands in which box of the layout, and which two are looked at together.
#pragma once

#include "render/frame.h"
#include "render/view_settings.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace flipbook::render {

struct Boxes {
  std::size_t count = 0;
  std::vector<std::size_t> of_pane;                      ///< the box of each pane; those of a split share one
  std::optional<std::size_t> large;                      ///< the box that is larger than the others
  std::optional<std::size_t> difference;                 ///< the last box, where there is one
  std::optional<std::array<std::size_t, 2>> split, pair; ///< panes: left and right; A and B
};

/// What a frame cannot have of what the settings ask for is left out, with a line in `warnings` that says why.
[[nodiscard]] Boxes boxes_of(const Frame& frame, const ViewSettings& view, std::vector<std::string>& warnings);

} // namespace flipbook::render
