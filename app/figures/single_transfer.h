// SPDX-License-Identifier: MIT
// One particle and the samples around it: the solver's own G2P and P2G, looked at.
#pragma once

#include "sim/core/field.h"
#include "sim/core/parallel.h"
#include "sim/core/particles.h"
#include "sim/kernels/kernels.h"
#include "sim/transfer/settings.h"

#include <functional>
#include <vector>

namespace flipbook::app {

/// A sample that a particle touches. Lengths are in cells.
struct TouchedSample {
  int axis;           ///< whose component it is; on nodes each sample is there for both
  double x, y;        ///< where
  double weight;      ///< w_ip
  double u;           ///< the grid's velocity there
  double painted = 0; ///< what the particle paints there after it has gathered
};

/// The velocity of the grid at a point, component by component.
using GridVelocity = std::function<double(int axis, double x, double y)>;

/// A particle at (x, y) of a small grid gathers from the velocity and paints what it keeps.
[[nodiscard]] std::vector<TouchedSample> gather_and_paint(const Corner& corner, KernelName kernel, Layout layout,
                                                          double x, double y, const GridVelocity& velocity, Pool& pool);

/// sum w painted^2 / sum w u^2.
[[nodiscard]] double energy_kept(const std::vector<TouchedSample>& samples);

} // namespace flipbook::app
