// SPDX-License-Identifier: MIT
#include "sim/core/order.h"

#include <numeric>
#include <type_traits>

namespace flipbook {
namespace {

constexpr std::int64_t max_chunks = 32;
constexpr std::int64_t min_chunk = 1 << 12;
constexpr std::uint32_t cells_per_range = 1 << 13;
constexpr std::int64_t moves_per_chunk = 1 << 14;

/// Particles per chunk: of the number of particles only, so that the same chunks are cut for any number of threads.
std::int64_t chunk_size(std::int64_t count) {
  return std::max(min_chunk, (count + max_chunks - 1) / max_chunks);
}

/// The cell of each particle, and how many of each chunk are in each cell.
template <int Dim, class Real>
void count_cells(const Particles<Dim, Real>& particles, const Grid<Dim>& grid, CellOrder<Dim>& order, Pool& pool) {
  auto& s = order.scratch;
  const auto count = static_cast<std::int64_t>(particles.size());
  const std::int64_t grain = chunk_size(count);
  s.cell.resize(particles.size());
  s.chunks.resize(static_cast<std::size_t>((count + grain - 1) / grain));
  pool.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
    constexpr std::uint32_t per_block = BlockedCells<Dim>::per_block;
    auto& chunk = s.chunks[static_cast<std::size_t>(begin / grain)];
    chunk.slot.assign(order.cells.blocks(), chunk.none);
    chunk.count.clear();
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
      const std::uint32_t cell = order.cells.number(cell_of(grid, particles.position(p)));
      s.cell[p] = cell;
      std::uint32_t& slot = chunk.slot[cell / per_block];
      if (slot == chunk.none) {
        slot = static_cast<std::uint32_t>(chunk.count.size());
        chunk.count.resize(chunk.count.size() + per_block, 0);
      }
      ++chunk.of(cell);
    }
  });
}

/// body(counts) for the counts that each chunk has of the cells of this block, chunks in order.
template <class Scratch, class Body> void each_count(Scratch& s, std::uint32_t block, Body&& body) {
  for (auto& chunk : s.chunks)
    if (const std::uint32_t slot = chunk.slot[block]; slot != chunk.none) body(chunk.count.data() + slot);
}

/// start, and in each chunk the place of its next particle for each cell. The particles of a cell keep their order
/// because the chunks are taken in order.
template <int Dim> void assign_places(CellOrder<Dim>& order, std::uint32_t count, Pool& pool) {
  constexpr std::uint32_t per_block = BlockedCells<Dim>::per_block, grain = cells_per_range / per_block;
  auto& s = order.scratch;
  const std::uint32_t blocks = order.cells.blocks();
  order.start.resize(std::size_t{order.cells.size()} + 1);
  s.below.assign((blocks + grain - 1) / grain, 0);
  const auto each_of_range = [&](auto&& body) { // body(block, its range, the starts of its cells)
    pool.ranges(blocks, grain, [&](std::int64_t begin, std::int64_t end) {
      for (auto b = static_cast<std::uint32_t>(begin); b < static_cast<std::uint32_t>(end); ++b)
        body(b, static_cast<std::uint32_t>(begin) / grain, order.start.data() + std::size_t{b} * per_block);
    });
  };
  each_of_range([&](std::uint32_t block, std::uint32_t range, std::uint32_t* start) {
    std::fill_n(start, per_block, 0u);
    each_count(s, block, [&](const std::uint32_t* counts) {
      for (std::uint32_t c = 0; c < per_block; ++c) start[c] += counts[c];
    });
    s.below[range] = std::accumulate(start, start + per_block, s.below[range]);
  });
  std::exclusive_scan(s.below.begin(), s.below.end(), s.below.begin(), 0u);
  each_of_range([&](std::uint32_t block, std::uint32_t range, std::uint32_t* start) {
    std::array<std::uint32_t, per_block> next;
    for (std::uint32_t c = 0; c < per_block; ++c) {
      const std::uint32_t many = start[c];
      start[c] = next[c] = s.below[range];
      s.below[range] += many;
    }
    each_count(s, block, [&](std::uint32_t* counts) {
      for (std::uint32_t c = 0; c < per_block; ++c) counts[c] = std::exchange(next[c], next[c] + counts[c]);
    });
  });
  order.start.back() = count;
}

/// Moves the entries of a column to their places.
template <class T>
void permute(std::vector<T>& column, std::vector<T>& room, const std::vector<std::uint32_t>& source, Pool& pool) {
  room.resize(column.size());
  pool.ranges(static_cast<std::int64_t>(column.size()), moves_per_chunk, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) room[i] = column[source[i]];
  });
  column.swap(room);
}

} // namespace

template <int Dim, class Real>
void sort_by_cell(Particles<Dim, Real>& particles, const Grid<Dim>& grid, CellOrder<Dim>& order, Pool& pool,
                  std::size_t carried) {
  auto& s = order.scratch;
  const auto count = static_cast<std::int64_t>(particles.size());
  const std::int64_t grain = chunk_size(count);
  order.cells = BlockedCells<Dim>(grid);
  count_cells(particles, grid, order, pool);
  assign_places(order, static_cast<std::uint32_t>(count), pool);

  s.source.resize(particles.size());
  pool.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
    auto& chunk = s.chunks[static_cast<std::size_t>(begin / grain)];
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      s.source[chunk.of(s.cell[p])++] = static_cast<std::uint32_t>(p);
  });

  auto& room = [&]() -> std::vector<Real>& {
    if constexpr (std::is_same_v<Real, float>)
      return s.single_column;
    else
      return s.double_column;
  }();
  for (auto& column : particles.x) permute(column, room, s.source, pool);
  for (auto& column : particles.v) permute(column, room, s.source, pool);
  for (auto& column : particles.A) permute(column, room, s.source, pool);
  for (std::size_t c = 0; c < std::min(carried, particles.carried.size()); ++c)
    permute(particles.carried[c], room, s.source, pool);
  permute(particles.m, room, s.source, pool);
  permute(particles.id, s.id, s.source, pool);
}

template void sort_by_cell(Particles<2, float>&, const Grid<2>&, CellOrder<2>&, Pool&, std::size_t);
template void sort_by_cell(Particles<2, double>&, const Grid<2>&, CellOrder<2>&, Pool&, std::size_t);
template void sort_by_cell(Particles<3, float>&, const Grid<3>&, CellOrder<3>&, Pool&, std::size_t);
template void sort_by_cell(Particles<3, double>&, const Grid<3>&, CellOrder<3>&, Pool&, std::size_t);

} // namespace flipbook
