// SPDX-License-Identifier: MIT
// The pressure of the fluid notes: A p = d on the fluid cells, in units where density, dt and h are 1.
//   A   diagonal: number of neighbours that are not solid; -1 for each fluid neighbour; p = 0 in empty cells
//   d   minus the sum of velocity differences of the cell
// Plain conjugate gradients from p = 0, until sigma <= 1e-6 sigma_0 (sigma = r.r) or after 1000 steps; dot products run
// over i, then j, then k. Then u <- u - (difference of p) on every face between two cells that are not solid. A right
// side of zero gives p = 0.
#pragma once

#include "sim/core/parallel.h"
#include "sim/tutorial/notes_state.h"

namespace flipbook {

class NotesPressure {
public:
  /// Makes u free of divergence; fills p, iterations and residual.
  void project(NotesState& state, Pool& pool);

private:
  void assemble(const NotesState& state);
  void solve(NotesState& state, Pool& pool);
  void multiply(Pool& pool);

  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Row {
    std::array<std::uint32_t, 6> neighbours; ///< rows; `none` where there is no fluid
    double diagonal;
  };
  std::vector<std::uint32_t> row_of_; ///< of each cell
  std::vector<std::size_t> cell_of_;  ///< of each row
  std::vector<Row> rows_;
  std::vector<double> d_, q_, r_, p_;
};

} // namespace flipbook
