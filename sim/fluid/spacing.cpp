// SPDX-License-Identifier: MIT
#include "sim/fluid/spacing.h"

#include <cmath>

namespace flipbook {

template <int Dim, class Real>
void correct_spacing(double strength, double spacing, const Grid<Dim>& grid, const Walls<Dim, Real>& walls,
                     const CellOrder<Dim>& order, Particles<Dim, Real>& particles, Pool& pool) {
  const auto before = particles.x;
  const Box<Dim> domain = cells_of(grid);
  const Real d = static_cast<Real>(spacing), dx = static_cast<Real>(grid.dx);
  const auto push = [&](std::size_t p, const Index<Dim>& cell) {
    Vec<Dim, Real> x, sum = Vec<Dim, Real>::Zero();
    for (int a = 0; a < Dim; ++a) x[a] = before[static_cast<std::size_t>(a)][p];
    each_in(grid, Box<Dim>{cell.array() - 1, cell.array() + 2}, [&](const Index<Dim>& c, std::size_t) {
      const Index<Dim> home = walls.image(c);
      if (!domain.contains(home)) return;
      const Vec<Dim, Real> shift = dx * (c - home).template cast<Real>();
      for (std::size_t q = order.begin(home); q < order.end(home); ++q) {
        Vec<Dim, Real> r = x - shift;
        for (int a = 0; a < Dim; ++a) r[a] -= before[static_cast<std::size_t>(a)][q];
        const Real length = r.norm();
        if (q == p || length >= d) continue;
        // Two particles in one place part along x, the one that comes first in the order to the left.
        if (length > 0)
          sum += (d - length) / (2 * length) * r;
        else
          sum[0] += q > p ? -d / 2 : d / 2;
      }
    });
    sum *= static_cast<Real>(strength);
    const Real length = sum.norm();
    if (length > d / 4) sum *= d / (4 * length);
    x += sum;
    walls.confine(x);
    particles.set_position(p, x);
  };
  each_in(grid, domain, pool, [&](const Index<Dim>& cell, std::size_t) {
    for (std::size_t p = order.begin(cell); p < order.end(cell); ++p) push(p, cell);
  });
}

#define FLIPBOOK_SPACING(Dim, Real)                                                                                    \
  template void correct_spacing(double, double, const Grid<Dim>&, const Walls<Dim, Real>&, const CellOrder<Dim>&,      \
                                Particles<Dim, Real>&, Pool&);
FLIPBOOK_SPACING(2, float)
FLIPBOOK_SPACING(2, double)
FLIPBOOK_SPACING(3, float)
FLIPBOOK_SPACING(3, double)
#undef FLIPBOOK_SPACING

} // namespace flipbook
