// SPDX-License-Identifier: MIT
#include "sim/frame/particle_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipbook {
namespace {

std::vector<std::uint32_t> cells_of(const Snapshot& s, const EachPiece& each_piece) {
  const auto dim = static_cast<std::size_t>(s.dim);
  const double inverse_dx = 1 / s.dx;
  std::vector<std::uint32_t> cell(s.particles());
  each_piece(cell.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      std::uint32_t index = 0;
      for (std::size_t a = dim; a-- > 0;) {
        const double c = (static_cast<double>(s.x[dim * p + a]) - s.lo[a]) * inverse_dx, last = s.cells[a] - 1;
        const double inside = c > 0 ? std::min(c, last) : 0; // also where c is not a number
        index = index * static_cast<std::uint32_t>(s.cells[a]) + static_cast<std::uint32_t>(inside);
      }
      cell[p] = index;
    }
  });
  return cell;
}

/// Which particle goes to each place.
std::vector<std::uint32_t> places(const Snapshot& s, const EachPiece& each_piece) {
  const std::vector<std::uint32_t> cell = cells_of(s, each_piece);
  std::size_t cells = 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a) cells *= static_cast<std::size_t>(s.cells[a]);
  std::vector<std::uint32_t> end(cells + 1, 0), order(cell.size());
  for (const std::uint32_t c : cell) ++end[c + 1];
  for (std::size_t c = 0; c < cells; ++c) end[c + 1] += end[c];
  for (std::uint32_t p = 0; p < cell.size(); ++p) order[end[cell[p]]++] = p; // afterwards end[c] is the end of cell c
  const auto earlier = [&](std::uint32_t p, std::uint32_t q) { return s.id[p] < s.id[q]; };
  each_piece(cells, [&](std::size_t first_cell, std::size_t last_cell) {
    for (std::size_t c = first_cell; c < last_cell; ++c) {
      const auto first = order.begin() + (c > 0 ? static_cast<std::ptrdiff_t>(end[c - 1]) : 0);
      const auto last = order.begin() + static_cast<std::ptrdiff_t>(end[c]);
      if (!std::is_sorted(first, last, earlier)) std::sort(first, last, earlier);
    }
  });
  return order;
}

/// `room` is what the last column lay in: memory that is not new is not cleared again.
template <class T>
void gather(std::vector<T>& values, std::size_t components, const std::vector<std::uint32_t>& order,
            std::vector<T>& room, const EachPiece& each_piece) {
  room.resize(values.size());
  each_piece(order.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (std::size_t c = 0; c < components; ++c) room[components * p + c] = values[components * order[p] + c];
  });
  values.swap(room);
}

} // namespace

void sort_particles(Snapshot& s, const EachPiece& each_piece) {
  const std::vector<std::uint32_t> order = places(s, each_piece);
  std::vector<float> points, numbers;
  gather(s.x, static_cast<std::size_t>(s.dim), order, points, each_piece);
  gather(s.v, static_cast<std::size_t>(s.dim), order, points, each_piece);
  std::vector<std::uint32_t> ids;
  gather(s.id, 1, order, ids, each_piece);
  for (Channel& c : s.channels)
    if (c.values.size() == order.size()) gather(c.values, 1, order, numbers, each_piece);
}

} // namespace flipbook
