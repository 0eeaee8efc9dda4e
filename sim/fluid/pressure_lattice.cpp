// SPDX-License-Identifier: MIT
#include "sim/fluid/pressure_lattice.h"

#include "sim/fluid/pressure_system.h"

#include <cstring>

namespace flipbook {
namespace {

constexpr std::int64_t cells_per_chunk = 1 << 14;

/// What the cells of a row are made from: arrays that begin at its first cell, and the way to the next one per axis.
template <int Dim, class Real> struct Source {
  const std::uint8_t* fluid;
  std::array<const Real*, Dim> open, inverse_theta, u, u_solid;
  std::array<std::ptrdiff_t, Dim> stride;

  Source(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells,
         const Components<Dim, Real>& velocity, std::size_t at)
      : fluid(cells.fluid.data() + at) {
    for (std::size_t a = 0; a < Dim; ++a) {
      open[a] = walls.open[a].data() + at;
      inverse_theta[a] = cells.inverse_theta[a].data() + at;
      u[a] = velocity[a].data() + at;
      u_solid[a] = walls.u_solid[a].data() + at;
      stride[a] = grid.stride(static_cast<int>(a));
    }
  }

  [[nodiscard]] Real weight(std::size_t a, std::ptrdiff_t face) const { return open[a][face] * inverse_theta[a][face]; }
  [[nodiscard]] Real flux(std::size_t a, std::ptrdiff_t face) const {
    return open[a][face] * u[a][face] + (1 - open[a][face]) * u_solid[a][face];
  }
  /// The weight of the lower face, where it couples two liquid cells.
  [[nodiscard]] Real w(std::size_t a, std::ptrdiff_t x) const {
    return fluid[x] & fluid[x - stride[a]] ? weight(a, x) : Real(0);
  }
  /// What the two faces along an axis add to e.
  [[nodiscard]] Real e(std::size_t a, std::ptrdiff_t x) const {
    if (!fluid[x]) return 0;
    return (fluid[x - stride[a]] ? Real(0) : weight(a, x)) +
           (fluid[x + stride[a]] ? Real(0) : weight(a, x + stride[a]));
  }
  [[nodiscard]] Real divergence(std::ptrdiff_t x) const {
    Real sum = 0;
    for (std::size_t a = 0; a < Dim; ++a) sum += flux(a, x + stride[a]) - flux(a, x);
    return sum;
  }
};

} // namespace

/// The box around the liquid; the whole of a periodic axis.
template <int Dim, class Real>
void PressureLattice<Dim, Real>::find_box(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                          const Cells<Dim, Real>& cells, Pool& pool) {
  const Box<Dim> all = cells_of(grid);
  const std::int64_t rows = rows_of(all), grain = std::max<std::int64_t>(1, cells_per_chunk / grid.cells[0]);
  const Box<Dim> nothing{all.hi, all.lo};
  boxes_.assign(static_cast<std::size_t>((rows + grain - 1) / grain), nothing);
  pool.ranges(rows, grain, [&](std::int64_t begin, std::int64_t end) {
    Box<Dim>& box = boxes_[static_cast<std::size_t>(begin / grain)];
    each_in_rows(grid, starts_of(all), begin, end, [&](const Index<Dim>& cell, std::size_t at) {
      const std::uint8_t* first = cells.fluid.data() + at;
      const auto* hit =
          static_cast<const std::uint8_t*>(std::memchr(first, 1, static_cast<std::size_t>(grid.cells[0])));
      if (!hit) return;
      std::ptrdiff_t last = grid.cells[0] - 1;
      while (!first[last]) --last;
      Index<Dim> lo = cell, hi = cell.array() + 1;
      lo[0] += static_cast<int>(hit - first);
      hi[0] += static_cast<int>(last);
      box.lo = box.lo.cwiseMin(lo);
      box.hi = box.hi.cwiseMax(hi);
    });
  });
  Box<Dim> box = nothing;
  for (const Box<Dim>& of_rows : boxes_) {
    box.lo = box.lo.cwiseMin(of_rows.lo);
    box.hi = box.hi.cwiseMax(of_rows.hi);
  }
  std::array<bool, Dim> periodic;
  for (int d = 0; d < Dim; ++d) {
    periodic[static_cast<std::size_t>(d)] = walls.periodic(d);
    if (!walls.periodic(d) && box.lo[d] < box.hi[d]) continue;
    box.lo[d] = all.lo[d];
    box.hi[d] = walls.periodic(d) ? all.hi[d] : all.lo[d] + 1;
  }
  corner_ = box.lo;
  const Board board(box.hi - box.lo, periodic);
  if (board == level().board) return;
  level().resize(board, pool);
  b.resize(board.half);
  b.clear(pool);
  if constexpr (!std::is_same_v<Real, float>) {
    exact_.resize(board.half);
    exact_.clear(pool);
  }
}

/// body(row of the checkerboard, position of its first cell in a field).
template <int Dim, class Real>
template <class Body>
void PressureLattice<Dim, Real>::each_row(const Grid<Dim>& grid, Pool& pool, Body&& body) const {
  const Board& board = level().board;
  pool.ranges(board.rows(), 1 + cells_per_chunk / board.n[0], [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t r = begin; r < end; ++r) {
      const auto row = board.row(r);
      body(row, static_cast<std::size_t>(grid.at(corner_ + row.cell)));
    }
  });
}

template <int Dim, class Real>
void PressureLattice<Dim, Real>::assemble(const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                          const Cells<Dim, Real>& cells, const Components<Dim, Real>& u, double density,
                                          double dt, Pool& pool) {
  find_box(grid, walls, cells, pool);
  const Board& board = level().board;
  Stencil<Dim, float>& A = level().A;
  const double scale = -density * grid.dx * grid.dx / dt;
  const Real inverse_dx = static_cast<Real>(1 / grid.dx);
  each_row(grid, pool, [&](const typename Board::Row& row, std::size_t start) {
    const Source<Dim, Real> source(grid, walls, cells, u, start);
    for (const int slot : {0, 1}) {
      const int colour = row.colour(slot), count = (board.n[0] + 1 - slot) / 2;
      const auto put = [&](auto& f, auto&& value) {
        auto* to = f.of(colour) + row.at;
        using T = std::remove_reference_t<decltype(*to)>;
        FLIPBOOK_INDEPENDENT
        for (int i = 0; i < count; ++i) to[i] = static_cast<T>(value(2 * i + slot));
        std::fill(to + count, to + board.places, T(0));
      };
      for (std::size_t a = 0; a < Dim; ++a) {
        put(A.w[a], [&](std::ptrdiff_t x) { return source.w(a, x); });
        if constexpr (!std::is_same_v<Real, float>) put(exact_.w[a], [&](std::ptrdiff_t x) { return source.w(a, x); });
      }
      const auto e = [&](std::ptrdiff_t x) { return over_axes<Dim>([&](auto a) { return source.e(a, x); }); };
      put(A.e, e);
      if constexpr (!std::is_same_v<Real, float>) put(exact_.e, e);
      put(b, [&](std::ptrdiff_t x) {
        return source.fluid[x] ? scale * static_cast<double>(source.divergence(x) * inverse_dx) : 0.0;
      });
    }
  });
  if constexpr (!std::is_same_v<Real, float>)
    for (auto& w : exact_.w) board.fill_pads(w, pool);
  const Board coarser((board.n.array() + 1) / 2, board.periodic);
  level().finish(nullptr, &coarser, pool);
  // A cell without an open face is no row of the matrix.
  each_row(grid, pool, [&](const typename Board::Row& row, std::size_t) {
    for (const int colour : {0, 1}) {
      double* to = b.of(colour) + row.at;
      const float* inverse = level().inverse_d.of(colour) + row.at;
      for (int i = 0; i < board.places; ++i) to[i] = inverse[i] > 0 ? to[i] : 0;
    }
  });
  pockets_.find(level());
  pockets_.remove_means(b, pool);
}

template <int Dim, class Real>
void PressureLattice<Dim, Real>::gather(const Grid<Dim>& grid, const Field<double>& p, Coloured<double>& to,
                                        Pool& pool) const {
  each_row(grid, pool, [&](const typename Board::Row& row, std::size_t start) {
    for (const int slot : {0, 1}) {
      const int colour = row.colour(slot), count = (level().board.n[0] + 1 - slot) / 2;
      const float* inverse = level().inverse_d.of(colour) + row.at;
      const double* from = p.data() + start + slot;
      double* values = to.of(colour) + row.at;
      for (int i = 0; i < count; ++i) values[i] = inverse[i] > 0 ? from[2 * i] : 0;
    }
  });
}

template <int Dim, class Real>
void PressureLattice<Dim, Real>::scatter(const Grid<Dim>& grid, const Coloured<double>& from, Field<double>& p,
                                         Pool& pool) const {
  pool.ranges(static_cast<std::int64_t>(p.size()), 1 << 16,
              [&](std::int64_t begin, std::int64_t end) { std::fill(p.begin() + begin, p.begin() + end, 0.0); });
  each_row(grid, pool, [&](const typename Board::Row& row, std::size_t start) {
    for (const int slot : {0, 1}) {
      const int colour = row.colour(slot), count = (level().board.n[0] + 1 - slot) / 2;
      const double* values = from.of(colour) + row.at;
      double* to = p.data() + start + slot;
      for (int i = 0; i < count; ++i) to[2 * i] = values[i];
    }
  });
}

template class PressureLattice<2, float>;
template class PressureLattice<2, double>;
template class PressureLattice<3, float>;
template class PressureLattice<3, double>;

} // namespace flipbook
