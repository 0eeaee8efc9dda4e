// SPDX-License-Identifier: MIT
// A solid body in the fluid: a shape where it starts, how it moves, and whether the fluid slips along it.
#pragma once

#include "sim/boundary/motion.h"
#include "sim/boundary/shape.h"

namespace flipbook {

struct Obstacle {
  ShapePtr shape;       ///< at rest
  MotionPtr motion{};   ///< null: it stands still
  bool no_slip = false; ///< the fluid sticks to it; else it glides along

  [[nodiscard]] Pose pose(double t) const { return motion ? motion->at(t) : Pose{}; }
};

} // namespace flipbook
