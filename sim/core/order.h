// SPDX-License-Identifier: MIT
// Particles in cell order, and loops over blocks of cells that may add to the grid without atomics.
//
// The cell of a particle is floor(x / dx) + pad on each axis; a stable counting sort puts the particles of a cell side
// by side, cells with x fastest. Blocks have edges of `block_edge` cells and 2^Dim colours, so that two blocks of one
// colour lie a whole block apart: no kernel reaches across (a cubic one on MAC faces reaches two samples beyond its
// cell). Colours run one after the other, so each sample receives its sum in one fixed order, whatever the number of
// threads.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/parallel.h"
#include "sim/core/particles.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipbook {

/// Where the particles of each cell are.
template <int Dim> struct CellOrder {
  /// grid.size() + 1 entries: the particles of cell c (Grid::at) are [start[c], start[c + 1]).
  std::vector<std::uint32_t> start;

  /// Room that sort_by_cell keeps from one call to the next.
  struct Scratch {
    struct Chunk {
      std::uint32_t lowest = 0; ///< smallest cell met
      std::vector<std::uint32_t>
          count; ///< of each cell from there on: first how many particles, then where the next goes
    };
    std::vector<std::uint32_t> cell;   ///< of each particle
    std::vector<std::uint32_t> source; ///< which particle moves to each place
    std::vector<std::uint32_t> below;  ///< particles before each range of cells
    std::vector<Chunk> chunks;
    std::vector<std::uint32_t> id;
    std::vector<float> single_column;
    std::vector<double> double_column;
  } scratch;
};

/// Position in grid units, counted from the first pad sample of a lattice with origin 0. Every index of a particle is
/// derived from this one rounded number, so that its cell and its stencil always agree.
template <class T, class Real> [[nodiscard]] constexpr T grid_position(T x, Real inverse_dx) {
  return x * T(inverse_dx) + T(Grid<2>::pad);
}

/// The cell that holds x, pads included.
template <int Dim, class Real> [[nodiscard]] Index<Dim> cell_of(const Grid<Dim>& grid, const Vec<Dim, Real>& x) {
  Index<Dim> c;
  for (int d = 0; d < Dim; ++d) c[d] = static_cast<int>(grid_position(x[d], static_cast<Real>(1 / grid.dx)));
  return c;
}

/// Sorts every column of the particles by cell; particles of one cell keep their order. Positions must lie in the
/// domain or its pads.
template <int Dim, class Real>
void sort_by_cell(Particles<Dim, Real>& particles, const Grid<Dim>& grid, CellOrder<Dim>& order, Pool& pool);

/// Cells along an edge of a block: a multiple of 4, and at least 4 for the reach of cubic kernels on MAC faces.
inline constexpr int block_edge = 8;

/// body(begin, end) for the runs of particles of the block whose first cell this is, row of cells after row of cells.
template <int Dim, class Body>
void each_run(const Grid<Dim>& grid, const CellOrder<Dim>& order, const Index<Dim>& first, Body&& body) {
  const Index<Dim> last = (first.array() + block_edge).min(grid.extent().array());
  for (Index<Dim> c = first; c[Dim - 1] < last[Dim - 1];) {
    Index<Dim> end = c;
    end[0] = last[0] - 1;
    const std::uint32_t p = order.start[static_cast<std::size_t>(grid.at(c))];
    const std::uint32_t q = order.start[static_cast<std::size_t>(grid.at(end)) + 1];
    if (p != q) body(std::size_t{p}, std::size_t{q});
    ++c[1]; // the next row of cells
    if constexpr (Dim == 3) {
      if (c[1] == last[1]) c[1] = first[1], ++c[2];
    }
  }
}

/// body(first) for the first cell of every block, colour after colour; blocks that run at the same time are a block
/// apart.
template <int Dim, class Body> void each_block(const Grid<Dim>& grid, Pool& pool, Body&& body) {
  const Index<Dim> extent = grid.extent();
  for (int colour = 0; colour < 1 << Dim; ++colour) {
    Index<Dim> parity, count;
    for (int d = 0; d < Dim; ++d) {
      parity[d] = colour >> d & 1;
      count[d] = (extent[d] + block_edge * (1 - parity[d]) + block_edge - 1) / (2 * block_edge);
    }
    pool.each(count.prod(), [&](int b) {
      Index<Dim> first;
      for (int d = 0; d < Dim; b /= count[d], ++d) first[d] = block_edge * (2 * (b % count[d]) + parity[d]);
      body(static_cast<const Index<Dim>&>(first));
    });
  }
}

} // namespace flipbook
