// SPDX-License-Identifier: MIT
// What stands for the particles in a pane, and what of the grid is drawn with them: settings below `view.`.
#pragma once

#include "sim/frame/parameters.h"

namespace flipbook::render {

enum class Style {
  discs,   ///< each particle; in 3D as a ball
  field,   ///< the quantity of view.colour as a smooth image inside the liquid (2D)
  surface, ///< the liquid as one body with an outline; in 3D its lit surface
};

enum class ArrowsAt {
  cells, ///< the velocity in the middle of cells
  faces, ///< one component on each MAC face, or the velocity at the nodes of the material point method
};

struct LookSettings {
  Style style = Style::discs;
  bool outline = false; ///< over discs and fields
  ArrowsAt arrows_at = ArrowsAt::cells;
  bool cell_types = false;
  double trails = 0; ///< seconds; 0: none

  void describe(ParameterVisitor& v);
  /// Is the outline of the liquid drawn, or anything that it cuts off?
  [[nodiscard]] bool needs_surface() const { return style != Style::discs || outline; }
};

} // namespace flipbook::render
