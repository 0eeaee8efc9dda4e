// SPDX-License-Identifier: MIT
// A lattice of a 2D pane at the middle of every pixel, by Catmull-Rom's cubic, which goes through the samples and gives
// back polynomials up to the second degree; where samples are closer together than pixels it is widened, so that it
// averages them. Beyond the last samples of a domain that is not periodic the nearest one holds.
#pragma once

#include "render/views/pane_view.h"
#include "render/workers.h"

#include <string_view>
#include <vector>

namespace flipbook::render {

/// A number for each pixel of an area of the picture, row by row from the top.
struct Pixels {
  Area area;
  std::vector<float> values;

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(x) + static_cast<std::size_t>(area.w) * static_cast<std::size_t>(y);
  }
};

/// Null: it was not published.
[[nodiscard]] const LatticeData* find_lattice(const Snapshot& s, std::string_view name);

/// What is visible of the domain of a pane in a picture of this size, without the pixels that its rounded frame covers.
[[nodiscard]] Area visible_domain(const PaneView& pane, int width, int height);

[[nodiscard]] Pixels resample(const LatticeData& lattice, const PaneView& pane, const Area& area,
                              const Workers& workers);

} // namespace flipbook::render
