// SPDX-License-Identifier: MIT
// What the cases read from a simulation in two dimensions: particles, the velocity on the faces of the grid, lattices.
#pragma once

#include "sim/simulation.h"

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace flipbook::app {

/// Particles in the order of their ids; metres and m/s.
struct ParticleState {
  std::vector<double> x, y, vx, vy;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};
[[nodiscard]] ParticleState particles_of(const Simulation& sim);

/// Largest |v_p|.
[[nodiscard]] double largest_speed(const ParticleState& particles);

/// A lattice of the snapshot: "u", "v", "phi", "p".
[[nodiscard]] const LatticeData& lattice(const Snapshot& s, std::string_view name);

/// A column of its history.
[[nodiscard]] const std::vector<float>& history_column(const Snapshot& s, std::string_view name);

/// Value at (x, y), bilinear between samples, constant beyond the outermost.
[[nodiscard]] double sample(const LatticeData& lattice, double x, double y);

using Point = std::array<double, 2>;

/// The velocity on the faces of a snapshot that was asked for them.
struct FaceVelocity {
  explicit FaceVelocity(const Snapshot& s);
  const LatticeData *u, *v;
  std::array<int, 2> cells;
  double dx;

  [[nodiscard]] Point at(double x, double y) const { return {sample(*u, x, y), sample(*v, x, y)}; }
  /// body(axis, x, y, velocity component) for every face, those of a periodic seam once; on a wall too.
  template <class Body> void each(Body&& body) const {
    const std::array<const LatticeData*, 2> lattices{u, v};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const LatticeData& l = *lattices[axis];
      for (int j = 0; j < l.n[1]; ++j)
        for (int i = 0; i < l.n[0]; ++i) {
          if (periodic[axis] && (axis == 0 ? i : j) == cells[axis]) continue;
          body(axis, static_cast<double>(l.origin[0]) + dx * i, static_cast<double>(l.origin[1]) + dx * j,
               static_cast<double>(l.values[static_cast<std::size_t>(i + l.n[0] * j)]));
        }
    }
  }
  /// Integral of |u|^2 / 2, in m^4/s^2: kinetic energy for a density of 1.
  [[nodiscard]] double energy() const;
  /// Vorticity at the inner nodes (i, j) dx of the grid, row after row of cells[0] + 1; on the border 0, or what a
  /// periodic axis gives.
  [[nodiscard]] std::vector<double> vorticity() const;

private:
  std::array<bool, 2> periodic;
};

/// |u - exact| / |exact| over the faces, root mean squares; exact(x, y) gives a Point.
template <class Exact> [[nodiscard]] double relative_error(const FaceVelocity& faces, Exact&& exact) {
  double off = 0, all = 0;
  faces.each([&](std::size_t axis, double x, double y, double u) {
    const double wanted = exact(x, y)[axis];
    off += (u - wanted) * (u - wanted);
    all += wanted * wanted;
  });
  return std::sqrt(off / all);
}

} // namespace flipbook::app
