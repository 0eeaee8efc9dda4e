// SPDX-License-Identifier: MIT
// A scene: settings, the bodies of fluid, and how long it is worth watching. One TOML file serves 2D and 3D: an axis
// that a shape does not list spans the domain.
#pragma once

#include "sim/boundary/shape.h"
#include "sim/scene/settings.h"
#include "sim/scene/toml_reader.h"
#include "sim/scene/velocity.h"

#include <string>
#include <vector>

namespace flipbook {

/// Fluid that is there at the start. Where bodies overlap, the first decides the velocity.
struct Body {
  ShapePtr shape;
  VelocityPtr velocity;
};

struct Scene {
  std::string name, summary, reference;
  double duration = 2; ///< seconds worth watching
  Settings settings;
  std::vector<Body> fluid;
  std::vector<Assignment> view; ///< `view.*` suggestions of the scene, for the program; unknown to the solver

  [[nodiscard]] Domain domain() const { return {settings.dim, settings.grid.size}; }
};

} // namespace flipbook
