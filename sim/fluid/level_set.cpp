// SPDX-License-Identifier: MIT
#include "sim/fluid/level_set.h"

#include <cmath>

namespace flipbook {
namespace {

/// The squared distance, in cells, from a cell's centre to the nearest particle in the cells up to `reach` away.
template <int Dim, class Real> class NearestParticle {
public:
  NearestParticle(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Particles<Dim, Real>& particles,
                  const CellOrder<Dim>& order)
      : grid_(grid), walls_(walls), particles_(particles), order_(order), domain_(cells_of(grid)),
        inverse_dx_(static_cast<Real>(1 / grid.dx)) {}

  [[nodiscard]] Real operator()(const Index<Dim>& cell, int reach, Real nearest) const {
    const Box<Dim> around{cell.array() - reach, cell.array() + reach + 1};
    if (!crosses_periodic_side(around))
      return inside(cell, {around.lo.cwiseMax(domain_.lo), around.hi.cwiseMin(domain_.hi)}, nearest);
    each_in(grid_, around, [&](const Index<Dim>& c, std::size_t) {
      const Index<Dim> home = walls_.image(c);
      if (!domain_.contains(home)) return;
      const auto at = static_cast<std::size_t>(grid_.at(home));
      visit(cell + home - c, order_.start[at], order_.start[at + 1], nearest);
    });
    return nearest;
  }

private:
  [[nodiscard]] bool crosses_periodic_side(const Box<Dim>& around) const {
    for (int a = 0; a < Dim; ++a)
      if (walls_.periodic(a) && (around.lo[a] < domain_.lo[a] || around.hi[a] > domain_.hi[a])) return true;
    return false;
  }

  /// Away from periodic sides the cells of a row are neighbours in memory: one run of particles for each row.
  [[nodiscard]] Real inside(const Index<Dim>& cell, const Box<Dim>& around, Real nearest) const {
    Box<Dim> rows = around;
    rows.hi[0] = rows.lo[0] + 1;
    const auto length = static_cast<std::size_t>(around.hi[0] - around.lo[0]);
    each_in(grid_, rows, [&](const Index<Dim>&, std::size_t at) {
      visit(cell, order_.start[at], order_.start[at + length], nearest);
    });
    return nearest;
  }

  /// `cell`: the cell whose centre is meant, moved along when its neighbour was found across a periodic side.
  void visit(const Index<Dim>& cell, std::uint32_t begin, std::uint32_t end, Real& nearest) const {
    std::array<Real, Dim> centre;
    for (int d = 0; d < Dim; ++d)
      centre[static_cast<std::size_t>(d)] = static_cast<Real>(cell[d] - Grid<Dim>::pad) + Real(0.5);
    for (std::size_t p = begin; p < end; ++p) {
      Real distance = 0;
      for (std::size_t d = 0; d < Dim; ++d) {
        const Real r = particles_.x[d][p] * inverse_dx_ - centre[d];
        distance += r * r;
      }
      nearest = std::min(nearest, distance);
    }
  }

  const Grid<Dim>& grid_;
  const Walls<Dim, Real>& walls_;
  const Particles<Dim, Real>& particles_;
  const CellOrder<Dim>& order_;
  Box<Dim> domain_;
  Real inverse_dx_;
};

} // namespace

template <int Dim> double particle_radius(double dx, int per_axis) {
  return (std::sqrt(Dim) + std::sqrt(Dim + 8)) / 4 * dx / per_axis;
}

template <int Dim, class Real>
void level_set(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Particles<Dim, Real>& particles,
               const CellOrder<Dim>& order, double radius, Field<Real>& phi, Pool& pool) {
  const NearestParticle<Dim, Real> nearest(grid, walls, particles, order);
  const Real dx = static_cast<Real>(grid.dx), r = static_cast<Real>(radius);
  phi.resize(static_cast<std::size_t>(grid.size()));
  each_in(grid, cells_of(grid), pool, [&](const Index<Dim>& cell, std::size_t at) {
    // A particle in the next cells is at least 1/2 dx away, in the next but one 3/2 dx: the near ones often settle it.
    Real distance = nearest(cell, 0, Real(4));
    if (distance > Real(0.25)) distance = nearest(cell, 1, distance);
    if (distance > Real(2.25)) distance = nearest(cell, 2, distance);
    phi[at] = dx * std::sqrt(distance) - r;
  });
  walls.pad_cells(phi);
}

template double particle_radius<2>(double, int);
template double particle_radius<3>(double, int);

#define FLIPBOOK_LEVEL_SET(Dim, Real)                                                                                  \
  template void level_set(const Grid<Dim>&, const Walls<Dim, Real>&, const Particles<Dim, Real>&,                      \
                          const CellOrder<Dim>&, double, Field<Real>&, Pool&);
FLIPBOOK_LEVEL_SET(2, float)
FLIPBOOK_LEVEL_SET(2, double)
FLIPBOOK_LEVEL_SET(3, float)
FLIPBOOK_LEVEL_SET(3, double)
#undef FLIPBOOK_LEVEL_SET

} // namespace flipbook
