// SPDX-License-Identifier: MIT
// How 3D panes are drawn: the parameters below `view.` that only they have.
#pragma once

#include "sim/frame/parameters.h"

namespace flipbook::render {

/// How much work a 3D picture is worth.
enum class Quality { draft, full };

struct SpaceSettings {
  Quality quality = Quality::full;
  bool spray = true; ///< drops apart from the surface
  bool tint = false; ///< the surface has the colours of the particles

  void describe(ParameterVisitor& v);
};

} // namespace flipbook::render
