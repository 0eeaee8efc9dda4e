// SPDX-License-Identifier: MIT
// What stands for the particles in a pane: the settings below `view.` that 2D and 3D views share.
#pragma once

#include "sim/frame/parameters.h"

namespace flipbook::render {

enum class Style {
  discs,   ///< each particle; in 3D as a ball
  field,   ///< the quantity of view.colour as a smooth image inside the liquid (2D)
  surface, ///< the liquid as one body with an outline; in 3D its lit surface
};

struct LookSettings {
  Style style = Style::discs;

  void describe(ParameterVisitor& v);
};

} // namespace flipbook::render
