// SPDX-License-Identifier: MIT
#include "sim/fluid/cells.h"

namespace flipbook {
namespace {

/// Smaller fractions would make the matrix arbitrarily ill-conditioned for a gain below the error of phi.
constexpr double smallest_theta = 0.01;

} // namespace

template <int Dim, class Real>
void Cells<Dim, Real>::classify(Surface surface, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                const CellOrder<Dim>& order, const Field<Real>& phi, Pool& pool,
                                const std::vector<std::size_t>& wet) {
  fluid.assign(static_cast<std::size_t>(grid.size()), 0);
  each_in(grid, cells_of(grid), pool, [&](const Index<Dim>& cell, std::size_t at) {
    bool open = false;
    for (int a = 0; a < Dim; ++a) {
      const Field<Real>& f = walls.open[static_cast<std::size_t>(a)];
      open = open || f[at] > 0 || f[at + static_cast<std::size_t>(grid.stride(a))] > 0;
    }
    const bool liquid = surface == Surface::full    ? true
                        : surface == Surface::voxel ? order.end(cell) > order.begin(cell)
                                                    : phi[at] < 0;
    fluid[at] = open && liquid;
  });
  for (const std::size_t at : wet) fluid[at] = 1;
  walls.wrap_cells(fluid);

  inverse_theta.resize(grid);
  for (int a = 0; a < Dim; ++a) {
    Field<Real>& f = inverse_theta[static_cast<std::size_t>(a)];
    const Field<Real>& open = walls.open[static_cast<std::size_t>(a)];
    each_in(grid, faces_of(grid, a), pool, [&](const Index<Dim>&, std::size_t at) {
      const std::size_t below = at - static_cast<std::size_t>(grid.stride(a));
      if (!fluid[at] && !fluid[below]) return;
      f[at] = 1;
      if (surface != Surface::ghost || fluid[at] == fluid[below] || open[at] == 0) return;
      const Real inside = fluid[at] ? phi[at] : phi[below], outside = fluid[at] ? phi[below] : phi[at];
      f[at] = 1 / std::max(inside / (inside - outside), static_cast<Real>(smallest_theta));
    });
  }
}

template <int Dim, class Real>
void Cells<Dim, Real>::mark_ballistic(const Grid<Dim>& grid, const CellOrder<Dim>& order,
                                      std::vector<std::uint8_t>& ballistic, Pool& pool) const {
  ballistic.resize(order.start.back());
  each_in(grid, cells_of(grid), pool, [&](const Index<Dim>& cell, std::size_t at) {
    const std::size_t begin = order.begin(cell);
    std::fill_n(ballistic.data() + begin, order.end(cell) - begin, static_cast<std::uint8_t>(fluid[at] ? 0 : 1));
  });
}

template struct Cells<2, float>;
template struct Cells<2, double>;
template struct Cells<3, float>;
template struct Cells<3, double>;

} // namespace flipbook
