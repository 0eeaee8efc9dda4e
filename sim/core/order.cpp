// SPDX-License-Identifier: MIT
#include "sim/core/order.h"

#include <numeric>
#include <type_traits>

namespace flipbook {
namespace {

constexpr std::int64_t max_chunks = 32;
constexpr std::int64_t min_chunk = 1 << 12;
constexpr std::int64_t cells_per_range = 1 << 13;
constexpr std::int64_t moves_per_chunk = 1 << 14;

/// Particles per chunk: of the number of particles only, so that the same chunks are cut for any number of threads.
std::int64_t chunk_size(std::int64_t count) {
  return std::max(min_chunk, (count + max_chunks - 1) / max_chunks);
}

/// The cell of each particle, and how many of each chunk are in each cell.
template <int Dim, class Real>
void count_cells(const Particles<Dim, Real>& particles, const Grid<Dim>& grid, typename CellOrder<Dim>::Scratch& s,
                 Pool& pool) {
  const auto count = static_cast<std::int64_t>(particles.size());
  const std::int64_t grain = chunk_size(count);
  s.cell.resize(particles.size());
  s.chunks.resize(static_cast<std::size_t>((count + grain - 1) / grain));
  pool.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
    auto& chunk = s.chunks[static_cast<std::size_t>(begin / grain)];
    std::uint32_t highest = 0;
    chunk.lowest = static_cast<std::uint32_t>(grid.size());
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
      const auto cell = static_cast<std::uint32_t>(grid.at(cell_of(grid, particles.position(p))));
      s.cell[p] = cell;
      chunk.lowest = std::min(chunk.lowest, cell);
      highest = std::max(highest, cell);
    }
    chunk.count.assign(highest - chunk.lowest + 1, 0);
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      ++chunk.count[s.cell[p] - chunk.lowest];
  });
}

/// body(chunk, first, last) for the cells [first, last) of this range that the chunk counts, chunks in order.
template <class Scratch, class Body> void each_overlap(Scratch& s, std::int64_t begin, std::int64_t end, Body&& body) {
  for (auto& chunk : s.chunks) {
    const auto first = std::max<std::int64_t>(begin, chunk.lowest);
    const auto last = std::min<std::int64_t>(end, chunk.lowest + static_cast<std::int64_t>(chunk.count.size()));
    if (first < last) body(chunk, static_cast<std::size_t>(first), static_cast<std::size_t>(last));
  }
}

/// start, and in each chunk the place of its next particle for each cell. The particles of a cell keep their order
/// because the chunks are taken in order.
template <int Dim> void assign_places(const Grid<Dim>& grid, CellOrder<Dim>& order, std::uint32_t count, Pool& pool) {
  auto& s = order.scratch;
  const auto cells = static_cast<std::int64_t>(grid.size());
  order.start.resize(static_cast<std::size_t>(cells) + 1);
  s.below.assign(static_cast<std::size_t>((cells + cells_per_range - 1) / cells_per_range), 0);
  pool.ranges(cells, cells_per_range, [&](std::int64_t begin, std::int64_t end) {
    std::fill(order.start.begin() + begin, order.start.begin() + end, 0u);
    each_overlap(s, begin, end, [&](const auto& chunk, std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) order.start[c] += chunk.count[c - chunk.lowest];
    });
    s.below[static_cast<std::size_t>(begin / cells_per_range)] =
        std::accumulate(order.start.begin() + begin, order.start.begin() + end, 0u);
  });
  std::exclusive_scan(s.below.begin(), s.below.end(), s.below.begin(), 0u);
  pool.ranges(cells, cells_per_range, [&](std::int64_t begin, std::int64_t end) {
    std::exclusive_scan(order.start.begin() + begin, order.start.begin() + end, order.start.begin() + begin,
                        s.below[static_cast<std::size_t>(begin / cells_per_range)]);
    std::vector<std::uint32_t> next(order.start.begin() + begin, order.start.begin() + end);
    each_overlap(s, begin, end, [&](auto& chunk, std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) {
        const std::uint32_t many = chunk.count[c - chunk.lowest];
        std::uint32_t& place = next[c - static_cast<std::size_t>(begin)];
        chunk.count[c - chunk.lowest] = place;
        place += many;
      }
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
void sort_by_cell(Particles<Dim, Real>& particles, const Grid<Dim>& grid, CellOrder<Dim>& order, Pool& pool) {
  auto& s = order.scratch;
  const auto count = static_cast<std::int64_t>(particles.size());
  const std::int64_t grain = chunk_size(count);
  count_cells(particles, grid, s, pool);
  assign_places(grid, order, static_cast<std::uint32_t>(count), pool);

  s.source.resize(particles.size());
  pool.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
    auto& chunk = s.chunks[static_cast<std::size_t>(begin / grain)];
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      s.source[chunk.count[s.cell[p] - chunk.lowest]++] = static_cast<std::uint32_t>(p);
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
  permute(particles.m, room, s.source, pool);
  permute(particles.id, s.id, s.source, pool);
}

template void sort_by_cell(Particles<2, float>&, const Grid<2>&, CellOrder<2>&, Pool&);
template void sort_by_cell(Particles<2, double>&, const Grid<2>&, CellOrder<2>&, Pool&);
template void sort_by_cell(Particles<3, float>&, const Grid<3>&, CellOrder<3>&, Pool&);
template void sort_by_cell(Particles<3, double>&, const Grid<3>&, CellOrder<3>&, Pool&);

} // namespace flipbook
