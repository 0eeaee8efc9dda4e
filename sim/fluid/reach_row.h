// SPDX-License-Identifier: MIT
// The curves of a collapse: how far it has come on the floor, and how high it still is at the wall (sim/core/reach.h).
#pragma once

#include "sim/core/particles.h"
#include "sim/core/reach.h"
#include "sim/fluid/walls.h"
#include "sim/frame/curves.h"
#include "sim/scene/settings.h"

#include <algorithm>

namespace flipbook {

/// Adds "front" and "height" (m) where there is gravity, a floor and a wall beside it.
template <int Dim, class Real>
void add_reach(HistoryRow& row, const Settings& settings, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
               const Particles<Dim, Real>& particles) {
  const std::array<double, 3> up = settings.fluid.up(Dim), &g = settings.fluid.gravity;
  if (std::all_of(g.begin(), g.begin() + Dim, [](double a) { return a == 0; })) return;
  const int vertical = up[0] != 0 ? 0 : up[1] != 0 ? 1 : 2;
  if (walls.periodic(vertical) || walls.periodic(vertical == 0 ? 1 : 0)) return;
  ReachFrame f;
  f.dim = Dim;
  f.dx = grid.dx;
  f.per_axis = settings.seeding.per_axis;
  for (int a = 0; a < Dim; ++a) f.size[static_cast<std::size_t>(a)] = grid.dx * grid.cells[a];
  const DamReach r = dam_reach(f, up, particles.size(), [&](std::size_t p, int axis) {
    return static_cast<double>(particles.x[static_cast<std::size_t>(axis)][p]);
  });
  row.add("front", "m", r.front);
  row.add("height", "m", r.height);
}

} // namespace flipbook
