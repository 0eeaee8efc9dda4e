// SPDX-License-Identifier: MIT
// The particles and the lattices of a solver on our grids as a still of a stage.
#pragma once

#include "sim/core/particles.h"
#include "sim/fluid/box.h"
#include "sim/frame/stage_still.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace flipbook {

/// Which step it is of.
struct StillOf {
  std::string_view stage;
  double time, dt;
};

/// The particles in the order of their ids, no samples.
template <int Dim, class Real>
[[nodiscard]] StageStill still_of_particles(const StillOf& of, const Grid<Dim>& grid,
                                            const Particles<Dim, Real>& particles,
                                            const std::vector<std::uint8_t>& ballistic = {}) {
  StageStill still;
  still.stage = of.stage;
  still.time = of.time;
  still.dt = of.dt;
  still.dim = Dim;
  still.dx = grid.dx;
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return particles.id[a] < particles.id[b]; });
  for (const std::size_t p : order) {
    still.id.push_back(particles.id[p]);
    for (std::size_t d = 0; d < Dim; ++d) {
      still.x.push_back(static_cast<double>(particles.x[d][p]));
      still.v.push_back(static_cast<double>(particles.v[d][p]));
    }
    if (!ballistic.empty()) still.ballistic.push_back(ballistic[p]);
  }
  return still;
}

/// value(position in the array) for each sample of the box; `origin` in cells.
template <int Dim, class Value>
void add_samples(StageStill& still, const Grid<Dim>& grid, const Box<Dim>& box, std::string name,
                 const Vec<Dim, double>& origin, Value&& value) {
  StageSamples s;
  s.name = std::move(name);
  for (int d = 0; d < Dim; ++d) {
    s.n[static_cast<std::size_t>(d)] = box.hi[d] - box.lo[d];
    s.origin[static_cast<std::size_t>(d)] = grid.dx * origin[d];
  }
  each_in(grid, box, [&](const Index<Dim>&, std::size_t at) { s.values.push_back(static_cast<double>(value(at))); });
  still.samples.push_back(std::move(s));
}

/// The velocity of the grid and the mass that it is of.
template <int Dim, class Real>
void add_velocity(StageStill& still, const Grid<Dim>& grid, Layout layout, const Components<Dim, Real>& m,
                  const Components<Dim, Real>& u) {
  static constexpr std::array<const char*, 3> names{"u", "v", "w"};
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    Box<Dim> box = faces_of(grid, a);
    if (layout == Layout::nodes) box.hi = box.lo + grid.cells + Index<Dim>::Ones();
    const auto origin = component_origin<Dim, double>(layout, a);
    add_samples(still, grid, box, names[axis], origin, [&](std::size_t at) { return u[axis][at]; });
    add_samples(still, grid, box, std::string("mass_") + names[axis], origin,
                [&](std::size_t at) { return m[axis][at]; });
  }
}

} // namespace flipbook
