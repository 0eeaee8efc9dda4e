// SPDX-License-Identifier: MIT
// Particles in cell order, and loops over blocks of cells that may add to the grid without atomics.
//
// The cell of a particle is floor(x / dx) + pad on each axis. Blocks have edges of `block_edge` cells; a stable
// counting sort puts the particles of a cell side by side, the cells of a block side by side, and blocks one after the
// other, x fastest in both. So the particles of a block are one stretch of every column, which memory delivers at full
// speed, and the samples around them stay in the nearest caches.
//
// Blocks have 2^Dim colours, so that two blocks of one colour lie a whole block apart: no kernel reaches across (a
// cubic one on MAC faces reaches two samples beyond its cell). Colours run one after the other, so each sample receives
// its sum in one fixed order, whatever the number of threads.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/parallel.h"
#include "sim/core/particles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipbook {

/// Cells along an edge of a block: a power of two, and at least 4 for the reach of cubic kernels on MAC faces.
inline constexpr int block_edge = 8;

/// The cells of a grid, pads included, numbered block by block. Blocks at the upper sides have cells that the grid has
/// not; nothing is ever in them.
template <int Dim> class BlockedCells {
public:
  static constexpr auto per_block = static_cast<std::uint32_t>(power(block_edge, Dim));

  BlockedCells() = default;
  explicit BlockedCells(const Grid<Dim>& grid) {
    for (std::size_t d = 0; d < Dim; ++d) {
      stride_[d] = blocks_;
      blocks_ *= static_cast<std::uint32_t>((grid.extent()[static_cast<int>(d)] + block_edge - 1) / block_edge);
    }
  }

  [[nodiscard]] std::uint32_t blocks() const { return blocks_; }
  [[nodiscard]] std::uint32_t size() const { return blocks_ * per_block; }
  [[nodiscard]] std::uint32_t number(const Index<Dim>& cell) const {
    std::uint32_t block = 0, within = 0, across = 1;
    for (std::size_t d = 0; d < Dim; ++d, across *= block_edge) {
      const auto i = static_cast<std::uint32_t>(cell[static_cast<int>(d)]);
      block += i / block_edge * stride_[d];
      within += i % block_edge * across;
    }
    return block * per_block + within;
  }

private:
  std::uint32_t blocks_ = 1;
  std::array<std::uint32_t, Dim> stride_{}; ///< of blocks
};

/// Where the particles of the cells of one row along x are.
template <int Dim> class CellRow {
public:
  /// `start`: that of cell 0 of the row.
  explicit CellRow(const std::uint32_t* start) : start_(start) {}

  [[nodiscard]] std::size_t begin(int i) const { return start_[offset(i)]; }
  [[nodiscard]] std::size_t end(int i) const { return start_[offset(i) + 1]; }

  /// body(begin, end) for the runs of particles of the cells [first, last).
  template <class Body> void each_run(int first, int last, Body&& body) const {
    for (int i = first; i < last;) {
      const int next = std::min(last, (i / block_edge + 1) * block_edge);
      if (begin(i) != end(next - 1)) body(begin(i), end(next - 1));
      i = next;
    }
  }

private:
  static std::size_t offset(int i) {
    const auto c = static_cast<std::size_t>(i);
    return c / block_edge * BlockedCells<Dim>::per_block + c % block_edge;
  }

  const std::uint32_t* start_;
};

/// Where the particles of each cell are.
template <int Dim> struct CellOrder {
  BlockedCells<Dim> cells;
  /// cells.size() + 1 entries: the particles of the cell with number c are [start[c], start[c + 1]).
  std::vector<std::uint32_t> start;

  [[nodiscard]] std::size_t begin(const Index<Dim>& cell) const { return start[cells.number(cell)]; }
  [[nodiscard]] std::size_t end(const Index<Dim>& cell) const { return start[cells.number(cell) + 1]; }
  /// The particles of the block whose first cell this is: [first, second).
  [[nodiscard]] std::pair<std::size_t, std::size_t> block(const Index<Dim>& first) const {
    const std::uint32_t c = cells.number(first);
    return {start[c], start[c + BlockedCells<Dim>::per_block]};
  }
  /// The row of this cell.
  [[nodiscard]] CellRow<Dim> row(Index<Dim> cell) const {
    cell[0] = 0;
    return CellRow<Dim>(start.data() + cells.number(cell));
  }

  /// Room that sort_by_cell keeps from one call to the next.
  struct Scratch {
    struct Chunk {
      static constexpr std::uint32_t none = ~std::uint32_t{0};
      std::vector<std::uint32_t> slot;  ///< of each block that has particles of the chunk: where its counts begin
      std::vector<std::uint32_t> count; ///< of each cell of these: first how many, then where the next one goes

      /// The count of the cell with this number, whose block has a slot.
      [[nodiscard]] std::uint32_t& of(std::uint32_t cell) {
        return count[slot[cell / BlockedCells<Dim>::per_block] + cell % BlockedCells<Dim>::per_block];
      }
    };
    std::vector<std::uint32_t> cell;   ///< of each particle
    std::vector<std::uint32_t> source; ///< which particle moves to each place
    std::vector<std::uint32_t> below;  ///< particles before each range of blocks
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
/// domain or its pads. Of the carried columns only the first `carried` move: whoever says less writes the others anew,
/// or they are the same for all particles.
template <int Dim, class Real>
void sort_by_cell(Particles<Dim, Real>& particles, const Grid<Dim>& grid, CellOrder<Dim>& order, Pool& pool,
                  std::size_t carried = static_cast<std::size_t>(-1));

namespace detail {
/// body(first) for the first cell of each of `count` blocks: those `origin + step n`, in blocks, in parallel.
template <int Dim, class Body>
void each_block_of(const Index<Dim>& count, const Index<Dim>& origin, int step, Pool& pool, Body&& body) {
  pool.each(count.prod(), [&](int b) {
    Index<Dim> first;
    for (int d = 0; d < Dim; b /= count[d], ++d) first[d] = block_edge * (step * (b % count[d]) + origin[d]);
    body(static_cast<const Index<Dim>&>(first));
  });
}
/// How many times `edge` cells it takes to cover so many.
template <int Dim> [[nodiscard]] Index<Dim> covering(const Index<Dim>& cells, int edge) {
  return (cells.array() + edge - 1) / edge;
}
} // namespace detail

/// body(first) for the first cell of every block, colour after colour; blocks that run at the same time are a block
/// apart.
template <int Dim, class Body> void each_block(const Grid<Dim>& grid, Pool& pool, Body&& body) {
  for (int colour = 0; colour < 1 << Dim; ++colour) {
    Index<Dim> parity;
    for (int d = 0; d < Dim; ++d) parity[d] = colour >> d & 1;
    const Index<Dim> rest = grid.extent() - block_edge * parity;
    detail::each_block_of(detail::covering<Dim>(rest, 2 * block_edge), parity, 2, pool, body);
  }
}

/// The same for bodies that keep to the cells of their block.
template <int Dim, class Body> void each_block_at_once(const Grid<Dim>& grid, Pool& pool, Body&& body) {
  const Index<Dim> count = detail::covering<Dim>(grid.extent(), block_edge);
  detail::each_block_of(count, Index<Dim>(Index<Dim>::Zero()), 1, pool, body);
}

} // namespace flipbook
