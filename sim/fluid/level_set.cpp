// SPDX-License-Identifier: MIT
#include "sim/fluid/level_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook {
namespace {

constexpr int farthest_reach = 2; ///< cells; phi is exact as far out as that
constexpr std::int64_t cells_per_chunk = 2048;

/// The squared distance, in cells, from a cell's centre to the nearest particle in the cells up to `reach` away.
template <int Dim, class Real> class NearestParticle {
public:
  NearestParticle(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Particles<Dim, Real>& particles,
                  const CellOrder<Dim>& order)
      : grid_(grid), walls_(walls), order_(order), domain_(cells_of(grid)),
        inverse_dx_(static_cast<Real>(1 / grid.dx)) {
    for (std::size_t d = 0; d < Dim; ++d) x_[d] = particles.x[d].data();
  }

  /// `nearest` after all particles up to `reach` away, given that those in nearer cells are in it already.
  [[nodiscard]] Real operator()(const Index<Dim>& cell, int reach, Real nearest) const {
    const Box<Dim> around{cell.array() - reach, cell.array() + reach + 1};
    if (!crosses_periodic_side(around)) return inside(cell, reach, nearest);
    each_in(grid_, around, [&](const Index<Dim>& c, std::size_t) {
      const Index<Dim> home = walls_.image(c);
      if (!domain_.contains(home)) return;
      visit(centre_of(cell + home - c), order_.begin(home), order_.end(home), nearest);
    });
    return nearest;
  }

  /// The cells along the row of `first` that may have a particle within the farthest reach: [begin, end).
  [[nodiscard]] std::pair<int, int> stretch(const Index<Dim>& first) const {
    Box<Dim> rows{first.array() - farthest_reach, first.array() + farthest_reach + 1};
    if (crosses_periodic_side(rows) || walls_.periodic(0)) return {domain_.lo[0], domain_.hi[0]};
    rows = {rows.lo.cwiseMax(domain_.lo), rows.hi.cwiseMin(domain_.hi)};
    rows.hi[0] = rows.lo[0] + 1;
    int begin = domain_.hi[0], end = domain_.lo[0];
    each_in(grid_, rows, [&](const Index<Dim>& cell, std::size_t) {
      const CellRow<Dim> row = order_.row(cell);
      begin = row.first_occupied(domain_.lo[0], begin);
      end = row.end_of_occupied(end, domain_.hi[0]);
    });
    return {std::max(begin - farthest_reach, domain_.lo[0]), std::min(end + farthest_reach, domain_.hi[0])};
  }

private:
  using Centre = std::array<Real, Dim>;

  [[nodiscard]] bool crosses_periodic_side(const Box<Dim>& around) const {
    for (int a = 0; a < Dim; ++a)
      if (walls_.periodic(a) && (around.lo[a] < domain_.lo[a] || around.hi[a] > domain_.hi[a])) return true;
    return false;
  }

  /// Away from periodic sides: the runs of particles of each row, or those at its two ends where the rest has been
  /// visited. Rows that lie too far away are left out; a thousandth of a cell is more than the rounding of any place.
  [[nodiscard]] Real inside(const Index<Dim>& cell, int reach, Real nearest) const {
    const int left = std::max(cell[0] - reach, domain_.lo[0]), right = std::min(cell[0] + reach + 1, domain_.hi[0]);
    const Centre centre = centre_of(cell);
    const auto visit_row = [&](const std::array<int, 2>& step) {
      Index<Dim> c = cell;
      Real apart = 0;
      bool around = false; // no cell of the row has been visited
      for (int d = 1; d < Dim; ++d) {
        const int n = step[static_cast<std::size_t>(d - 1)];
        c[d] += n;
        if (c[d] < domain_.lo[d] || c[d] >= domain_.hi[d]) return;
        const Real gap = n == 0 ? Real(0) : static_cast<Real>(std::abs(n)) - Real(0.501);
        apart += gap * gap;
        around = around || std::abs(n) == reach;
      }
      if (apart >= nearest) return;
      const CellRow<Dim> row = order_.row(c);
      if (around || reach == 0)
        return row.each_run(left, right,
                            [&](std::size_t begin, std::size_t end) { visit(centre, begin, end, nearest); });
      if (cell[0] - reach == left) visit(centre, row.begin(left), row.end(left), nearest);
      if (cell[0] + reach + 1 == right) visit(centre, row.begin(right - 1), row.end(right - 1), nearest);
    };
    const int across = Dim == 3 ? reach : 0;
    for (int k = -across; k <= across; ++k)
      for (int j = -reach; j <= reach; ++j) visit_row({j, k});
    return nearest;
  }

  /// In cells. Beside a periodic side `cell` is moved along with what was found across it.
  [[nodiscard]] static Centre centre_of(const Index<Dim>& cell) {
    Centre centre;
    for (int d = 0; d < Dim; ++d)
      centre[static_cast<std::size_t>(d)] = static_cast<Real>(cell[d] - Grid<Dim>::pad) + Real(0.5);
    return centre;
  }

  [[nodiscard]] Real distance(const Centre& centre, std::size_t p) const {
    Real sum = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      const Real r = x_[d][p] * inverse_dx_ - centre[d];
      sum += r * r;
    }
    return sum;
  }

  /// Minima side by side, which a processor takes at once; a minimum does not depend on the order.
  void visit(const Centre& centre, std::size_t begin, std::size_t end, Real& nearest) const {
    constexpr std::size_t lanes = 16 / sizeof(Real);
    std::size_t p = begin;
    if (end - begin >= lanes) {
      std::array<Real, lanes> least;
      least.fill(nearest);
      for (; p + lanes <= end; p += lanes)
        for (std::size_t l = 0; l < lanes; ++l) {
          const Real d = distance(centre, p + l);
          least[l] = d < least[l] ? d : least[l];
        }
      nearest = *std::min_element(least.begin(), least.end());
    }
    for (; p < end; ++p) nearest = std::min(nearest, distance(centre, p));
  }

  const Grid<Dim>& grid_;
  const Walls<Dim, Real>& walls_;
  std::array<const Real*, Dim> x_;
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
  constexpr Real far = farthest_reach * farthest_reach;
  const auto value = [&](const Index<Dim>& cell) {
    // A particle in the next cells is at least 1/2 dx away, in the next but one 3/2 dx: the near ones often settle it.
    Real distance = nearest(cell, 0, far);
    if (distance > Real(0.25)) distance = nearest(cell, 1, distance);
    if (distance > Real(2.25)) distance = nearest(cell, 2, distance);
    return dx * std::sqrt(distance) - r;
  };
  phi.resize(static_cast<std::size_t>(grid.size()));
  Box<Dim> rows = cells_of(grid);
  const int lo = rows.lo[0], hi = rows.hi[0];
  rows.hi[0] = lo + 1;
  const std::int64_t grain = std::max<std::int64_t>(1, cells_per_chunk / grid.cells[0]);
  pool.ranges(detail::rows_of(rows), grain, [&](std::int64_t first, std::int64_t last) {
    detail::each_in_rows(grid, rows, first, last, [&](const Index<Dim>& row, std::size_t at) {
      const auto [begin, end] = nearest.stretch(row);
      Real* out = phi.data() + at - lo;
      std::fill(out + lo, out + hi, dx * std::sqrt(far) - r);
      Index<Dim> cell = row;
      for (cell[0] = begin; cell[0] < end; ++cell[0]) out[cell[0]] = value(cell);
    });
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
