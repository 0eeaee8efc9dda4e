// SPDX-License-Identifier: MIT
// The colours of the two themes. Both are quiet, so that the data is the brightest thing in the picture.
#pragma once

#include "render/shapes.h"
#include "render/view_settings.h"

#include <array>

namespace flipbook::render {

struct Palette {
  Colour page, pane, text, muted;                          ///< backgrounds; text and secondary text
  Colour line, grid, wall;                                 ///< separators, lattice lines, solid walls
  Colour track, accent, grip;                              ///< widgets: trough, filled part, handle
  Colour floor, floor_grid, far_wall, far_edge, near_edge; ///< the tank of a 3D pane
  Colour shadow;                                           ///< and how much of it the darkest has
  Colour water, drop, horizon, zenith;                     ///< a liquid in 3D: itself, its spray, what it mirrors
  Colour solid, outline;                                   ///< bodies in 3D; the outline of those in 2D
  Colour liquid, liquid_edge;                              ///< as one body in 2D
  Colour cell_liquid, cell_air, cell_solid;                ///< tints of cells
  Colour arrow, warning;
  Colour holds, fails;             ///< what a proposition promises and the ledger finds
  std::array<Colour, 12> variants; ///< frame of a pane and its curves
  [[nodiscard]] Colour variant(std::size_t i) const { return variants[i % variants.size()]; }
};

[[nodiscard]] const Palette& palette(Theme theme);

} // namespace flipbook::render
