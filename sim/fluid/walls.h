// SPDX-License-Identifier: MIT
// The sides of the domain, which are cell faces. Per axis:
//   free_slip  u.n = U.n at and beyond the wall; tangential velocity continues into the pads
//   no_slip    u = U at and beyond the wall, as in an obstacle: what particles gave to the samples there the wall
//   takes. (A
//              mirrored velocity, 2 U - u, does work on them: APIC gained energy without bound.)
//   periodic   the two sides are one: sums that landed in the pads are folded back, values are copied out
// Solids inside the domain use the same two arrays: how far each face is open, and how fast the solid part of it moves.
#pragma once

#include "sim/core/field.h"
#include "sim/fluid/box.h"
#include "sim/scene/settings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace flipbook {

template <int Dim, class Real> class Walls {
public:
  Walls(const Grid<Dim>& grid, const WallSettings& settings);

  /// Of a cell, between a wall and what comes next to it: it keeps the last position before the wall apart from the
  /// wall in single precision as well.
  static constexpr double gap = 1e-3;

  Components<Dim, Real> open;    ///< open fraction of each face: 1 open, 0 solid
  Components<Dim, Real> u_solid; ///< velocity of its solid part (m/s)
  /// Which faces in the domain an obstacle closes, one byte each; empty without obstacles.
  std::array<std::vector<std::uint8_t>, Dim> buried;

  [[nodiscard]] bool periodic(int axis) const { return kind_[static_cast<std::size_t>(axis)] == Wall::periodic; }
  /// Does any wall hold the fluid back (no_slip)?
  [[nodiscard]] bool friction() const { return std::find(kind_.begin(), kind_.end(), Wall::no_slip) != kind_.end(); }

  /// Adds what particles near a periodic side put into its pads to the samples they stand for.
  void fold(Field<Real>& sums) const;
  void fold(Components<Dim, Real>& sums) const;

  /// u = u_solid on every closed face of the domain's sides; obstacles may slip (see solids.h).
  void close(Components<Dim, Real>& u, Pool& pool) const;

  /// Fills the pads with what the walls do to the flow beside them.
  void pad(Components<Dim, Real>& u) const { pad(u, true); }
  /// Fills the pads without friction: beyond a no_slip wall they keep what the particles near it gave them.
  void pad_slip(Components<Dim, Real>& u) const { pad(u, false); }
  /// Fills the pads of a quantity at cell centres: copied from the nearest cell, or from the other side.
  template <class T> void pad_cells(std::vector<T>& cells) const;
  /// The same across periodic sides only.
  template <class T> void wrap_cells(std::vector<T>& cells) const;

  /// The sample of the domain that i stands for: itself, or its image across periodic sides.
  [[nodiscard]] Index<Dim> image(Index<Dim> i) const;

  /// Brings a position back into the domain: across periodic sides, or to just inside of a wall. Bit 2a is set where it
  /// met the lower wall of axis a, bit 2a + 1 for the upper one.
  unsigned confine(Vec<Dim, Real>& x) const;

private:
  void pad(Components<Dim, Real>& u, bool friction) const;

  Grid<Dim> grid_;
  std::array<Wall, Dim> kind_;
};

} // namespace flipbook
