// SPDX-License-Identifier: MIT
// Which cells are liquid, and how far from a liquid cell's centre the surface lies on the way to an air cell.
//   ghost  liquid where phi(x_c) < 0; p = 0 on the surface, at the fraction theta = phi_i / (phi_i - phi_j) of the way
//          from cell i to air cell j (at least 0.01): second order [Gibou et al. 2002]
//   voxel  liquid where a cell holds a particle; p = 0 at the centre of the air cell: theta = 1
//   full   every cell that is open is liquid
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"
#include "sim/fluid/walls.h"

#include <cstdint>
#include <vector>

namespace flipbook {

template <int Dim, class Real> struct Cells {
  std::vector<std::uint8_t> fluid; ///< 1 where liquid; pads across periodic sides filled, 0 behind walls
  /// 1/theta on faces between liquid and air, 1 between two liquid cells or liquid and solid, 0 where no liquid cell is
  /// near: such a face takes no part in the projection.
  Components<Dim, Real> inverse_theta;

  /// `wet`: cells that are liquid besides those that hold a particle (voxel only).
  void classify(Surface surface, const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const CellOrder<Dim>& order,
                const Field<Real>& phi, Pool& pool, const std::vector<std::size_t>& wet = {});

  /// Marks the particles whose cell is not liquid: they fly on their own.
  void mark_ballistic(const Grid<Dim>& grid, const CellOrder<Dim>& order, std::vector<std::uint8_t>& ballistic,
                      Pool& pool) const;
};

} // namespace flipbook
