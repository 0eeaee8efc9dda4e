// SPDX-License-Identifier: MIT
// Boxes of lattice samples, and loops over them: index and position in the array together, x fastest.
#pragma once

#include "sim/core/lattice.h"
#include "sim/core/parallel.h"

#include <algorithm>

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

namespace detail {
/// The first sample of a row of a box; rows are its samples without the x axis, y fastest.
template <int Dim> [[nodiscard]] Index<Dim> row_start(const Box<Dim>& box, std::int64_t row) {
  Index<Dim> i = box.lo;
  for (int d = 1; d < Dim; ++d) {
    const int n = box.hi[d] - box.lo[d];
    i[d] += static_cast<int>(row % n);
    row /= n;
  }
  return i;
}
/// body(index, position) along the rows [first, last) of a box.
template <int Dim, class Body>
void each_in_rows(const Grid<Dim>& grid, const Box<Dim>& box, std::int64_t first, std::int64_t last, Body&& body) {
  for (std::int64_t row = first; row < last; ++row) {
    Index<Dim> i = row_start(box, row);
    std::ptrdiff_t at = grid.at(i);
    for (; i[0] < box.hi[0]; ++i[0], ++at) body(static_cast<const Index<Dim>&>(i), static_cast<std::size_t>(at));
  }
}
template <int Dim> [[nodiscard]] std::int64_t rows_of(const Box<Dim>& box) {
  std::int64_t rows = 1;
  for (int d = 0; d < Dim; ++d) {
    if (box.hi[d] <= box.lo[d]) return 0;
    if (d > 0) rows *= box.hi[d] - box.lo[d];
  }
  return rows;
}
} // namespace detail

/// body(index, position) for each sample of the box, in order.
template <int Dim, class Body> void each_in(const Grid<Dim>& grid, const Box<Dim>& box, Body&& body) {
  detail::each_in_rows(grid, box, 0, detail::rows_of(box), body);
}

/// The same, rows in parallel: the body may write to its own sample only.
template <int Dim, class Body> void each_in(const Grid<Dim>& grid, const Box<Dim>& box, Pool& pool, Body&& body) {
  const std::int64_t grain = std::max(1, 8192 / std::max(1, box.hi[0] - box.lo[0]));
  pool.ranges(detail::rows_of(box), grain,
              [&](std::int64_t b, std::int64_t e) { detail::each_in_rows(grid, box, b, e, body); });
}

/// body(first, position, length) for each row of the box along x, rows in parallel: for loops that compilers can take
/// several samples at a time through.
template <int Dim, class Body> void each_row(const Grid<Dim>& grid, const Box<Dim>& box, Pool& pool, Body&& body) {
  const std::int64_t rows = detail::rows_of(box), length = std::max(1, box.hi[0] - box.lo[0]);
  pool.ranges(rows, std::max<std::int64_t>(1, 8192 / length), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t row = begin; row < end; ++row) {
      const Index<Dim> first = detail::row_start(box, row);
      body(first, static_cast<std::size_t>(grid.at(first)), static_cast<std::size_t>(length));
    }
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
