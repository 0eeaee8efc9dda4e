// SPDX-License-Identifier: MIT
// Obstacles for tests.
#pragma once

#include "tests/physics/flow.h"

namespace flipbook::test {

inline Listed at(double x, double y) {
  return {{x, y, 0}, 2};
}
inline Listed at(double x, double y, double z) {
  return {{x, y, z}, 3};
}

inline ShapePtr complement(ShapePtr shape) {
  return make_difference({make_box(at(-100, -100), at(100, 100)), std::move(shape)});
}

/// Moves by offset(t) and turns by angle(t) about the z axis through the centre.
template <class Offset, class Angle> MotionPtr scripted(Offset offset, Angle angle, const Point& centre) {
  return make_motion([=](double t) { return Displacement{offset(t), angle(t)}; }, {0, 0, 1}, centre);
}
inline MotionPtr steady(const Point& velocity) {
  return scripted(
      [=](double t) {
        return Point{velocity[0] * t, velocity[1] * t, velocity[2] * t};
      },
      [](double) { return 0.0; }, {0, 0, 0});
}
inline MotionPtr spinning(double rate, const Point& centre) {
  return scripted([](double) { return Point{0, 0, 0}; }, [=](double t) { return rate * t; }, centre);
}

/// Liquid that no obstacle holds, at rest.
template <int Dim, class Real = double, class Inside>
Particles<Dim, Real> seed_around(const Settings& s, const std::vector<Obstacle>& obstacles, Inside&& inside) {
  const Domain domain = domain_of(s);
  return seed<Dim, Real>(
      s,
      [&](const auto& x) {
        Point p{0, 0, 0};
        std::copy_n(x.data(), Dim, p.begin());
        for (const Obstacle& o : obstacles)
          if (o.shape->contains(o.pose(0).back(p), domain)) return false;
        return inside(x);
      },
      at_rest<Dim>);
}

/// How deep the deepest particle is in an obstacle (m), by the shapes where they should be now; negative: all are
/// outside.
template <int Dim, class Real> double deepest(const Flow<Dim, Real>& flow) {
  const auto& state = flow.state();
  const Domain domain = domain_of(state.settings);
  double depth = -1e300;
  for (const Obstacle& o : state.solids.all()) {
    const Pose pose = o.pose(flow.solver.time());
    for (std::size_t p = 0; p < flow.particles().size(); ++p) {
      Point x{0, 0, 0};
      for (std::size_t d = 0; d < Dim; ++d) x[d] = static_cast<double>(flow.particles().x[d][p]);
      depth = std::max(depth, -o.shape->distance(pose.back(x), domain));
    }
  }
  return depth;
}

/// Largest |div u| of a liquid cell (1/s).
template <int Dim, class Real> double max_divergence(const FluidState<Dim, Real>& s) {
  double worst = 0;
  each_in(s.grid, cells_of(s.grid), [&](const Index<Dim>&, std::size_t at) {
    if (s.cells.fluid[at]) worst = std::max(worst, std::abs(static_cast<double>(divergence(s.grid, s.walls, s.u, at))));
  });
  return worst;
}

} // namespace flipbook::test
