// SPDX-License-Identifier: MIT
// The liquid of a 2D pane as an area: filled with one colour or with a field, and its outline. Edges cover pixels
// partly. Whatever the lattices leave out (drops that the solver's level set does not resolve) is added as discs of the
// area that a particle stands for, so that no liquid is drawn away.
#pragma once

#include "render/theme.h"
#include "render/views/colour_by.h"
#include "render/views/smooth_particles.h"

namespace flipbook::render {

struct AreaStyle {
  bool fill = true;       ///< false: the outline alone
  bool one_colour = true; ///< false: the quantity of the scale
  float line = 0;         ///< width of the outline in pixels; 0: none
  Colour liquid, outline;
};

/// Straight alpha, row by row from the top.
struct AreaPicture {
  Area area;
  std::vector<Colour> pixels;
};

/// Distance from the liquid at each pixel (m), negative inside.
[[nodiscard]] Pixels surface_pixels(const PaneView& pane, const Area& area, const Workers& workers);

/// `values` as colour_values gives them.
[[nodiscard]] AreaPicture paint_areas(const PaneView& pane, std::span<const float> values, const ColourScale& scale,
                                      const AreaStyle& style, const Area& area, const Workers& workers);

} // namespace flipbook::render
