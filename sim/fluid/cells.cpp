// SPDX-License-Identifier: MIT
#include "sim/fluid/cells.h"

#include "sim/fluid/box.h"

#include <algorithm>

namespace flipbook {
namespace {

/// Smaller fractions would make the matrix arbitrarily ill-conditioned for a gain below the error of phi.
constexpr double smallest_theta = 0.01;

} // namespace

template <int Dim, class Real>
void Cells<Dim, Real>::classify(Surface surface, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                                const CellOrder<Dim>& order, const Field<Real>& phi, Pool& pool,
                                const std::vector<std::size_t>& wet) {
  // Loops that compilers take several cells at a time through. Pads stay what the first time made them.
  fluid.resize(static_cast<std::size_t>(grid.size()), 0);
  each_row(grid, cells_of(grid), pool, [&](const Index<Dim>& first, std::size_t at, std::size_t length) {
    std::uint8_t* is = fluid.data() + at;
    std::fill_n(is, length, std::uint8_t{0});
    for (int a = 0; a < Dim; ++a) {
      const Real *lower = walls.open[static_cast<std::size_t>(a)].data() + at, *upper = lower + grid.stride(a);
      for (std::size_t i = 0; i < length; ++i) is[i] |= static_cast<std::uint8_t>((lower[i] > 0) | (upper[i] > 0));
    }
    const Real* inside = phi.data() + at;
    if (surface == Surface::ghost)
      for (std::size_t i = 0; i < length; ++i) is[i] &= static_cast<std::uint8_t>(inside[i] < 0);
    if (surface != Surface::voxel) return;
    const CellRow<Dim> row = order.row(first);
    for (std::size_t i = 0; i < length; ++i) {
      const int cell = first[0] + static_cast<int>(i);
      is[i] &= static_cast<std::uint8_t>(row.begin(cell) != row.end(cell));
    }
  });
  for (const std::size_t at : wet) fluid[at] = 1;
  walls.wrap_cells(fluid);

  for (int axis = 0; axis < Dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    inverse_theta[a].resize(fluid.size(), 0);
    each_row(grid, faces_of(grid, axis), pool, [&](const Index<Dim>&, std::size_t at, std::size_t length) {
      const std::uint8_t *is = fluid.data() + at, *below_is = is - grid.stride(axis);
      Real* f = inverse_theta[a].data() + at;
      for (std::size_t i = 0; i < length; ++i) f[i] = static_cast<Real>(is[i] | below_is[i]);
      if (surface != Surface::ghost) return;
      const Real *here = phi.data() + at, *below = here - grid.stride(axis), *open = walls.open[a].data() + at;
      for (std::size_t i = 0; i < length; ++i) {
        if (is[i] == below_is[i] || open[i] == 0) continue;
        const Real inside = is[i] ? here[i] : below[i], outside = is[i] ? below[i] : here[i];
        f[i] = 1 / std::max(inside / (inside - outside), static_cast<Real>(smallest_theta));
      }
    });
  }
}

template <int Dim, class Real>
void Cells<Dim, Real>::mark_ballistic(const Grid<Dim>& grid, const CellOrder<Dim>& order,
                                      std::vector<std::uint8_t>& ballistic, Pool& pool) const {
  ballistic.resize(order.start.back());
  each_row(grid, cells_of(grid), pool, [&](const Index<Dim>& first, std::size_t at, std::size_t length) {
    const std::uint8_t* is = fluid.data() + at;
    const CellRow<Dim> row = order.row(first);
    const int lo = first[0];
    for (std::size_t i = 0, next; i < length; i = next) {
      next = static_cast<std::size_t>(std::find(is + i, is + length, static_cast<std::uint8_t>(1 - is[i])) - is);
      row.each_run(lo + static_cast<int>(i), lo + static_cast<int>(next), [&](std::size_t begin, std::size_t end) {
        std::fill(ballistic.data() + begin, ballistic.data() + end, static_cast<std::uint8_t>(1 - is[i]));
      });
    }
  });
}

template struct Cells<2, float>;
template struct Cells<2, double>;
template struct Cells<3, float>;
template struct Cells<3, double>;

} // namespace flipbook
