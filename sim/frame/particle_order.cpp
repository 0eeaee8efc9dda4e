// SPDX-License-Identifier: MIT
#include "sim/frame/particle_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipbook {
namespace {

std::vector<std::uint32_t> cells_of(const Snapshot& s) {
  const auto dim = static_cast<std::size_t>(s.dim);
  const double inverse_dx = 1 / s.dx;
  std::vector<std::uint32_t> cell(s.particles());
  for (std::size_t p = 0; p < cell.size(); ++p) {
    std::uint32_t index = 0;
    for (std::size_t a = dim; a-- > 0;) {
      const double c = (static_cast<double>(s.x[dim * p + a]) - s.lo[a]) * inverse_dx, last = s.cells[a] - 1;
      const double inside = c > 0 ? std::min(c, last) : 0; // also where c is not a number
      index = index * static_cast<std::uint32_t>(s.cells[a]) + static_cast<std::uint32_t>(inside);
    }
    cell[p] = index;
  }
  return cell;
}

/// Which particle goes to each place.
std::vector<std::uint32_t> places(const Snapshot& s) {
  std::vector<std::uint32_t> cell = cells_of(s);
  std::size_t cells = 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a) cells *= static_cast<std::size_t>(s.cells[a]);
  std::vector<std::uint32_t> end(cells + 1, 0), order(cell.size());
  for (const std::uint32_t c : cell) ++end[c + 1];
  for (std::size_t c = 0; c < cells; ++c) end[c + 1] += end[c];
  for (std::uint32_t p = 0; p < cell.size(); ++p) order[end[cell[p]]++] = p; // afterwards end[c] is the end of cell c
  const auto earlier = [&](std::uint32_t p, std::uint32_t q) { return s.id[p] < s.id[q]; };
  for (std::size_t c = 0, begin = 0; c < cells; begin = end[c++]) {
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = order.begin() + static_cast<std::ptrdiff_t>(end[c]);
    if (!std::is_sorted(first, last, earlier)) std::sort(first, last, earlier);
  }
  return order;
}

template <class T>
void gather(std::vector<T>& values, std::size_t components, const std::vector<std::uint32_t>& order) {
  std::vector<T> sorted(values.size());
  for (std::size_t p = 0; p < order.size(); ++p)
    for (std::size_t c = 0; c < components; ++c) sorted[components * p + c] = values[components * order[p] + c];
  values = std::move(sorted);
}

} // namespace

void sort_particles(Snapshot& s) {
  const std::vector<std::uint32_t> order = places(s);
  gather(s.x, static_cast<std::size_t>(s.dim), order);
  gather(s.v, static_cast<std::size_t>(s.dim), order);
  gather(s.id, 1, order);
  for (Channel& c : s.channels)
    if (c.values.size() == order.size()) gather(c.values, 1, order);
}

} // namespace flipbook
