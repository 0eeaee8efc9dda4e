// SPDX-License-Identifier: MIT
// The particles as a structure of arrays, kept in cell order. Positions are metres from the lower corner of the domain.
#pragma once

#include "sim/core/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flipbook {

/// What a particle remembers besides its velocity; decides how many numbers `A` holds (see sim/transfer/modes.h).
enum class AffineMode { none, rigid, full, polynomial };

template <int Dim> [[nodiscard]] constexpr int affine_size(AffineMode mode) {
  switch (mode) {
  case AffineMode::none: return 0;
  case AffineMode::rigid: return spin<Dim>;
  case AffineMode::full: return Dim * Dim;
  case AffineMode::polynomial: break;
  }
  return Dim * ((1 << Dim) - 1);
}

template <int Dim, class Real> struct Particles {
  std::array<std::vector<Real>, Dim> x, v; ///< position (m) and velocity (m/s), one array for each axis
  std::vector<Real> m;                     ///< mass (kg; kg/m in 2D)
  std::vector<std::uint32_t> id;           ///< seeding order; never reused
  AffineMode mode = AffineMode::none;
  std::vector<std::vector<Real>>
      A; ///< affine_size(mode) columns (1/s): rigid: omega; full: C row by row, C(a,b) = dv_a/dx_b;
         ///< polynomial: for each a the coefficients of x, y, xy(, z, xz, yz, xyz) in v_a (1/s, 1/(m s), ..)
  std::vector<std::vector<Real>> carried; ///< columns of a solver's own, which sorting moves along

  [[nodiscard]] std::size_t size() const { return id.size(); }

  /// Changes what is remembered; the new columns start at zero (the caller gathers them from the grid).
  void set_mode(AffineMode next) {
    mode = next;
    A.assign(static_cast<std::size_t>(affine_size<Dim>(next)), std::vector<Real>(size(), Real(0)));
  }

  [[nodiscard]] Vec<Dim, Real> position(std::size_t p) const { return gather(x, p); }
  [[nodiscard]] Vec<Dim, Real> velocity(std::size_t p) const { return gather(v, p); }
  void set_position(std::size_t p, const Vec<Dim, Real>& q) { scatter(x, p, q); }
  void set_velocity(std::size_t p, const Vec<Dim, Real>& q) { scatter(v, p, q); }

  void add(const Vec<Dim, Real>& position, const Vec<Dim, Real>& velocity, Real mass, std::uint32_t name) {
    for (int d = 0; d < Dim; ++d) {
      x[static_cast<std::size_t>(d)].push_back(position[d]);
      v[static_cast<std::size_t>(d)].push_back(velocity[d]);
    }
    m.push_back(mass);
    id.push_back(name);
    for (auto& column : A) column.push_back(Real(0));
    for (auto& column : carried) column.push_back(Real(0));
  }

private:
  using Columns = std::array<std::vector<Real>, Dim>;
  static Vec<Dim, Real> gather(const Columns& c, std::size_t p) {
    Vec<Dim, Real> q;
    for (int d = 0; d < Dim; ++d) q[d] = c[static_cast<std::size_t>(d)][p];
    return q;
  }
  static void scatter(Columns& c, std::size_t p, const Vec<Dim, Real>& q) {
    for (int d = 0; d < Dim; ++d) c[static_cast<std::size_t>(d)][p] = q[d];
  }
};

} // namespace flipbook
