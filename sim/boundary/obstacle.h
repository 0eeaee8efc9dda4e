// SPDX-License-Identifier: MIT
// A solid body in the way: a shape where it starts, how it moves, and what happens along it.
#pragma once

#include "sim/boundary/motion.h"
#include "sim/boundary/shape.h"

namespace flipbook {

struct Obstacle {
  ShapePtr shape;          ///< at rest
  MotionPtr motion{};      ///< null: it stands still
  bool no_slip = false;    ///< what meets it sticks; else it glides along
  bool separating = false; ///< what meets it may leave it again (mpm; a liquid always may)
  double friction = 0;     ///< Coulomb's coefficient, where it separates

  [[nodiscard]] Pose pose(double t) const { return motion ? motion->at(t) : Pose{}; }
};

} // namespace flipbook
