// SPDX-License-Identifier: MIT
// Boxes of lattice samples, and loops over them: index and position in the array together, x fastest.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace flipbook {

/// Samples lo <= i < hi.
template <int Dim> struct Box {
  Index<Dim> lo, hi;

  [[nodiscard]] bool contains(const Index<Dim>& i) const {
    return (i.array() >= lo.array()).all() && (i.array() < hi.array()).all();
  }
};

/// The cells of the domain.
template <int Dim> [[nodiscard]] Box<Dim> cells_of(const Grid<Dim>& grid) {
  return {Index<Dim>::Constant(Grid<Dim>::pad), grid.cells.array() + Grid<Dim>::pad};
}

/// The faces of `axis` in the domain, those on its boundary included.
template <int Dim> [[nodiscard]] Box<Dim> faces_of(const Grid<Dim>& grid, int axis) {
  Box<Dim> box = cells_of(grid);
  ++box.hi[axis];
  return box;
}

/// Every sample, pads included.
template <int Dim> [[nodiscard]] Box<Dim> all_of(const Grid<Dim>& grid) {
  return {Index<Dim>::Zero(), grid.extent()};
}

/// The two slabs of samples of cells (or of faces seen along another axis) that lie outside the domain along `axis`,
/// the lower one first.
template <int Dim> [[nodiscard]] std::array<Box<Dim>, 2> outside(const Grid<Dim>& grid, int axis) {
  const Box<Dim> domain = cells_of(grid);
  Box<Dim> below = all_of(grid), above = all_of(grid);
  below.hi[axis] = domain.lo[axis];
  above.lo[axis] = domain.hi[axis];
  return {below, above};
}

/// The first sample of each row along x.
template <int Dim> [[nodiscard]] Box<Dim> starts_of(Box<Dim> box) {
  box.hi[0] = std::min(box.hi[0], box.lo[0] + 1);
  return box;
}

/// Rows of a box are its samples without the x axis, y fastest.
template <int Dim> [[nodiscard]] std::int64_t rows_of(const Box<Dim>& box) {
  std::int64_t rows = 1;
  for (int d = 0; d < Dim; ++d) {
    if (box.hi[d] <= box.lo[d]) return 0;
    if (d > 0) rows *= box.hi[d] - box.lo[d];
  }
  return rows;
}

/// body(index, position) along the rows [first, last) of a box.
template <int Dim, class Body>
void each_in_rows(const Grid<Dim>& grid, const Box<Dim>& box, std::int64_t first, std::int64_t last, Body&& body) {
  for (std::int64_t row = first; row < last; ++row) {
    Index<Dim> i = box.lo;
    std::int64_t rest = row;
    for (int d = 1; d < Dim; rest /= box.hi[d] - box.lo[d], ++d)
      i[d] += static_cast<int>(rest % (box.hi[d] - box.lo[d]));
    std::ptrdiff_t at = grid.at(i);
    for (; i[0] < box.hi[0]; ++i[0], ++at) body(static_cast<const Index<Dim>&>(i), static_cast<std::size_t>(at));
  }
}

/// So many rows of this length are enough work for a thread.
[[nodiscard]] inline std::int64_t rows_per_chunk(int length) {
  return std::max(1, 8192 / std::max(1, length));
}

/// body(index, position) for each sample of the box, in order.
template <int Dim, class Body> void each_in(const Grid<Dim>& grid, const Box<Dim>& box, Body&& body) {
  each_in_rows(grid, box, 0, rows_of(box), body);
}

/// The same, rows in parallel: the body may write to its own sample only.
template <int Dim, class Body> void each_in(const Grid<Dim>& grid, const Box<Dim>& box, Pool& pool, Body&& body) {
  pool.ranges(rows_of(box), rows_per_chunk(box.hi[0] - box.lo[0]),
              [&](std::int64_t begin, std::int64_t end) { each_in_rows(grid, box, begin, end, body); });
}

/// body(first, position, length) for each row of the box, rows in parallel: for loops that compilers can take several
/// samples at a time through.
template <int Dim, class Body> void each_row(const Grid<Dim>& grid, const Box<Dim>& box, Pool& pool, Body&& body) {
  const int length = box.hi[0] - box.lo[0];
  pool.ranges(rows_of(box), rows_per_chunk(length), [&](std::int64_t begin, std::int64_t end) {
    each_in_rows(grid, starts_of(box), begin, end,
                 [&](const Index<Dim>& first, std::size_t at) { body(first, at, static_cast<std::size_t>(length)); });
  });
}

/// body(node, corner) for the corners of the face of `axis` at a position, or of the cell there where the axis is -1;
/// bit d of `corner` is set on the upper side along d.
template <int Dim, class Body> void each_corner(const Grid<Dim>& grid, std::size_t at, int axis, Body&& body) {
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    if (axis >= 0 && (corner >> axis & 1)) continue;
    std::size_t node = at;
    for (int d = 0; d < Dim; ++d)
      if (corner >> d & 1) node += static_cast<std::size_t>(grid.stride(d));
    body(node, corner);
  }
}

} // namespace flipbook
