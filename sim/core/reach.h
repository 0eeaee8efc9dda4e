// SPDX-License-Identifier: MIT
// How far a body of particles has come along a wall: the front of a collapsing column on the floor, its height at the
// wall behind it. Of the particles in a layer one cell thick on the wall
//   reach = x_(k) + (ceil(k / n) - 1/2) spacing,
// where x_(k) is the k-th foremost and n particles lie side by side across the layer. So a full lattice gives the place
// where its liquid ends, and what is fewer than k particles - single drops ahead - does not count. k is as many as a
// cell holds; in 3D that for every fourth cell across.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace flipbook {

/// The walls and what was seeded beside them.
struct ReachFrame {
  int dim = 2;
  std::array<double, 3> size{1, 1, 1}; ///< of the domain, m
  double dx = 1;
  int per_axis = 2; ///< particles in a cell along an axis, at first
  int along = 0, wall = 1;
  bool from_far_side = false; ///< the layer is on the far wall: a floor that is above, where gravity points up
  bool to_far_side = false;   ///< the reach is counted from the far end of its axis
};

/// In metres from the end of the axis `along`; 0 where the layer holds fewer than k particles. position(p, axis) is in
/// metres from the lower corner.
template <class Position> [[nodiscard]] double reach(const ReachFrame& f, std::size_t particles, Position&& position) {
  std::vector<double> layer;
  const double thick = f.size[static_cast<std::size_t>(f.wall)];
  const double length = f.size[static_cast<std::size_t>(f.along)];
  for (std::size_t p = 0; p < particles; ++p) {
    const double from_wall = f.from_far_side ? thick - position(p, f.wall) : position(p, f.wall);
    if (from_wall < f.dx) layer.push_back(f.to_far_side ? length - position(p, f.along) : position(p, f.along));
  }
  const auto cell = static_cast<std::size_t>(f.per_axis);
  std::size_t across = cell, k = cell * cell; // a plane: n and k
  if (f.dim == 3) {
    const double cells = std::max(1.0, std::round(f.size[static_cast<std::size_t>(3 - f.along - f.wall)] / f.dx));
    across = static_cast<std::size_t>(cells) * cell * cell;
    k = static_cast<std::size_t>(std::ceil(cells / 4)) * cell * cell * cell;
  }
  if (layer.size() < k) return 0;
  const auto foremost = layer.begin() + static_cast<std::ptrdiff_t>(k - 1);
  std::nth_element(layer.begin(), foremost, layer.end(), std::greater<>());
  const double rows = std::ceil(static_cast<double>(k) / static_cast<double>(across));
  return *foremost + (rows - 0.5) * f.dx / f.per_axis;
}

/// The two curves that every run with a floor and walls beside it has.
struct DamReach {
  double front = 0;  ///< on the floor along x, from the lower wall
  double height = 0; ///< at that wall, from the floor
};

/// `up`: against gravity, along an axis. x is the first axis that is not up.
template <class Position>
[[nodiscard]] DamReach dam_reach(ReachFrame f, const std::array<double, 3>& up, std::size_t particles,
                                 Position&& position) {
  const auto vertical =
      static_cast<int>(std::find_if(up.begin(), up.end(), [](double x) { return x != 0; }) - up.begin());
  const int horizontal = vertical == 0 ? 1 : 0;
  const bool hanging = up[static_cast<std::size_t>(vertical)] < 0;
  DamReach r;
  f.along = horizontal, f.wall = vertical, f.from_far_side = hanging, f.to_far_side = false;
  r.front = reach(f, particles, position);
  f.along = vertical, f.wall = horizontal, f.from_far_side = false, f.to_far_side = hanging;
  r.height = reach(f, particles, position);
  return r;
}

} // namespace flipbook
