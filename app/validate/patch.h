// SPDX-License-Identifier: MIT
// The particles that began near a place. In an inviscid flow vorticity goes with the liquid, so that those of a vortex
// core stay in it: their centre is where the vortex is, without a search for maxima.
#pragma once

#include "app/validate/measure.h"

namespace flipbook::app {

class Patch {
public:
  /// Those within `radius` of (x, y).
  Patch(const ParticleState& at_start, double x, double y, double radius);

  /// Their mean place in a box whose axes are periodic with these lengths.
  [[nodiscard]] Point centre(const ParticleState& now, const Point& period) const;

private:
  std::vector<std::size_t> members_; ///< places in the table, which is in the order of the ids
};

} // namespace flipbook::app
