// SPDX-License-Identifier: MIT
#include "sim/fluid/level_set.h"

#include "sim/core/pack.h"
#include "sim/core/unrolled.h"
#include "sim/fluid/box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace flipbook {
namespace {

constexpr int farthest_reach = 2; ///< cells; phi is exact as far out as that
constexpr std::int64_t samples_per_chunk = 1 << 15;

constexpr int far = farthest_reach * farthest_reach; ///< squared

/// f <- the squared distance, in cells, from each centre to the nearest particle up to the farthest reach away, as far
/// as the particles of one block decide it.
template <int Dim, class Real> class NearestParticle {
public:
  NearestParticle(const Grid<Dim>& grid, const Particles<Dim, Real>& particles, const CellOrder<Dim>& order,
                  Field<Real>& f)
      : grid_(grid), order_(order), inverse_dx_(static_cast<Real>(1 / grid.dx)), f_(f.data()) {
    for (std::size_t d = 0; d < Dim; ++d) x_[d] = particles.x[d].data();
  }

  /// From the centres of the block's cells to their own particles.
  void own(const Index<Dim>& block) const {
    const std::uint32_t* start = order_.start.data() + order_.cells.number(block);
    for (int r = 0; r < cell_rows; ++r, start += block_edge) {
      if (start[0] == start[block_edge]) continue;
      Index<Dim> cell = cell_of(block, 0, r);
      Real* f = f_ + grid_.at(cell);
      for (int i = 0; i < block_edge; ++i, ++cell[0])
        if (start[i] != start[i + 1]) f[i] = least_distance(centre_of(cell), start[i], start[i + 1]);
    }
  }

  /// From all other centres that the block's particles may be nearest to. Reads and writes f up to the farthest reach
  /// around the block.
  void others(const Index<Dim>& block) const {
    const std::uint32_t* start = order_.start.data() + order_.cells.number(block);
    if (start[0] == start[BlockedCells<Dim>::per_block]) return;
    Around around;
    std::array<Bits, cell_rows> settled, near;
    around.read(grid_, block, f_);
    Bits open = 0;
    for (int r = 0; r < cell_rows; ++r) {
      const auto n = static_cast<std::size_t>(r);
      near[n] = around.template all<farthest_reach>(around.within_3_halves, r);
      settled[n] = near[n] & around.template all<1>(around.within_half, r);
      open |= ~settled[n];
    }
    if ((open & ((1U << block_edge) - 1)) == 0) return;
    // Cells side by side along y come one after the other, then the next cell along x: the rows of centres of one cell
    // then overlap with those before it in whole packs or not at all, and no read waits for half a write.
    for (int i = 0; i < block_edge; ++i)
      for (int r = 0; r < cell_rows; ++r) {
        const std::uint32_t *begin = start + r * block_edge + i, *end = begin + 1;
        const auto n = static_cast<std::size_t>(r);
        if (*begin == *end || (settled[n] >> i & 1)) continue;
        const Index<Dim> cell = cell_of(block, i, r);
        if (near[n] >> i & 1)
          visit<1>(around.first(i, r, 1), centre_of(cell.array() - 1), *begin, *end);
        else
          visit<farthest_reach>(around.first(i, r, farthest_reach), centre_of(cell.array() - farthest_reach), *begin,
                                *end);
      }
    around.write(grid_, block, f_);
  }

private:
  using T = Pack<Real>;
  using Centre = std::array<Real, Dim>; ///< in cells
  using Bits = std::uint32_t;           ///< one for each cell of a row
  static constexpr std::size_t lanes = lanes_of<T>;
  static constexpr int cell_rows = static_cast<int>(BlockedCells<Dim>::per_block) / block_edge; ///< of a block
  static constexpr int edge = block_edge + 2 * farthest_reach;
  /// Of packs, for the centres of a row that are up to `reach` away.
  template <int reach> static constexpr std::size_t packs = (2 * reach + lanes) / lanes;
  static constexpr std::size_t row_length = block_edge + packs<farthest_reach> * lanes;

  /// Cell i of row r of a block.
  [[nodiscard]] static Index<Dim> cell_of(Index<Dim> block, int i, int r) {
    block[0] += i;
    block[1] += r % block_edge;
    if constexpr (Dim == 3) block[2] += r / block_edge;
    return block;
  }
  [[nodiscard]] static Centre centre_of(const Index<Dim>& cell) {
    Centre centre;
    for (int d = 0; d < Dim; ++d)
      centre[static_cast<std::size_t>(d)] = static_cast<Real>(cell[d] - Grid<Dim>::pad) + Real(0.5);
    return centre;
  }

  /// f in and around a block. A particle is at least 1/2 away from the centre of the next cell, and 3/2 from that of
  /// the next but one: where f is less already it is not the nearest.
  struct Around {
    static constexpr std::size_t rows = Dim == 3 ? edge * edge : edge;
    std::array<Bits, rows> within_half, within_3_halves;
    alignas(64) std::array<Real, rows * row_length> f;

    /// Beyond the samples of the grid nothing is to be found.
    void read(const Grid<Dim>& grid, const Index<Dim>& block, const Real* from) {
      f.fill(Real(0));
      each_row(grid, block, [&](Real* row, std::ptrdiff_t at, int length) { std::copy_n(from + at, length, row); });
      for (std::size_t r = 0; r < rows; ++r) {
        const Real* row = f.data() + r * row_length;
        within_half[r] = within_3_halves[r] = 0;
        for (int n = 0; n < edge; ++n) {
          within_half[r] |= Bits{row[n] <= Real(0.25)} << n;
          within_3_halves[r] |= Bits{row[n] <= Real(2.25)} << n;
        }
      }
    }
    void write(const Grid<Dim>& grid, const Index<Dim>& block, Real* to) {
      each_row(grid, block, [&](const Real* row, std::ptrdiff_t at, int length) { std::copy_n(row, length, to + at); });
    }
    /// The first centre of those up to `reach` away from cell i of row r of the block.
    [[nodiscard]] Real* first(int i, int r, int reach) {
      return f.data() + lowest_row(r, reach) * row_length + static_cast<std::size_t>(i + farthest_reach - reach);
    }
    /// The cells of row r of the block whose neighbours up to `reach` away have their bits set.
    template <int reach> [[nodiscard]] Bits all(const std::array<Bits, rows>& bits, int r) const {
      constexpr std::size_t width = 2 * reach + 1;
      Bits column = ~Bits{0};
      for (std::size_t k = 0; k < (Dim == 3 ? width : 1); ++k)
        for (std::size_t j = 0; j < width; ++j) column &= bits[lowest_row(r, reach) + k * edge + j];
      Bits around = column;
      for (std::size_t n = 1; n < width; ++n) around &= column >> n;
      return around >> (farthest_reach - reach);
    }

  private:
    [[nodiscard]] static std::size_t lowest_row(int r, int reach) {
      const int y = r % block_edge, z = r / block_edge, lowest = farthest_reach - reach;
      return static_cast<std::size_t>(Dim == 3 ? (z + lowest) * edge + y + lowest : y + lowest);
    }
    /// body(row, position, length) for what the grid has of each row.
    template <class Body> void each_row(const Grid<Dim>& grid, const Index<Dim>& block, Body&& body) {
      const Index<Dim> corner = block.array() - farthest_reach;
      const Box<Dim> within{corner.cwiseMax(0), (corner.array() + edge).min(grid.extent().array())};
      const int length = within.hi[0] - within.lo[0];
      each_in(grid, starts_of(within), [&](const Index<Dim>& i, std::size_t at) {
        const Index<Dim> n = i - corner;
        const int row = Dim == 3 ? n[Dim - 1] * edge + n[1] : n[1];
        body(f.data() + static_cast<std::size_t>(row) * row_length + n[0], static_cast<std::ptrdiff_t>(at), length);
      });
    }
  };

  [[nodiscard]] Real least_distance(const Centre& centre, std::size_t begin, std::size_t end) const {
    using V = Narrow<Real>;
    constexpr std::size_t together = sizeof(V) / sizeof(Real);
    V least = V{} + Real(far);
    for (std::size_t next = begin; next < end; next += together) {
      // The last ones of many together with some of those before: a minimum takes them twice.
      const std::size_t p = end - begin < together ? begin : std::min(next, end - together);
      V sum{};
      for (std::size_t d = 0; d < Dim; ++d) {
        const V r = load_narrow(x_[d] + p, end - p) * inverse_dx_ - centre[d];
        sum += r * r;
      }
      least = sum < least ? sum : least;
    }
    Real nearest = least[0];
    for (std::size_t l = 1; l < together; ++l) nearest = std::min<Real>(nearest, least[l]);
    return nearest;
  }

  /// Measures the particles [begin, end) from the centres up to `reach` away from their cell: from a row of them at a
  /// time, with neighbours along x in the lanes. `lowest` is the first centre, and f what is known there.
  template <int reach> void visit(Real* f, const Centre& lowest, std::size_t begin, std::size_t end) const {
    constexpr std::size_t width = 2 * reach + 1, rows = Dim == 3 ? width * width : width, n = packs<reach>;
    std::array<T, n> centres;
    for (std::size_t k = 0; k < n; ++k) centres[k] = T(lowest[0] + static_cast<Real>(k * lanes)) + counting();
    std::array<std::array<T, n>, rows> least;
    for (auto& l : least) l.fill(T(Real(far)));
    for (std::size_t p = begin; p < end; ++p) {
      std::array<T, n> along;
      for (std::size_t k = 0; k < n; ++k) {
        const T r = T(x_[0][p] * inverse_dx_) - centres[k];
        along[k] = r * r;
      }
      std::array<std::array<Real, width>, Dim> apart; // squared, on the axes above x
      for (std::size_t d = 1; d < Dim; ++d)
        for (std::size_t j = 0; j < width; ++j) {
          const Real r = x_[d][p] * inverse_dx_ - (lowest[d] + static_cast<Real>(j));
          apart[d][j] = r * r;
        }
      unrolled<rows>([&]<std::size_t r>() {
        for (std::size_t k = 0; k < n; ++k) {
          T sum = along[k] + T(apart[1][r % width]);
          if constexpr (Dim == 3) sum = sum + T(apart[2][r / width]);
          least[r][k] = min(least[r][k], sum);
        }
      });
    }
    unrolled<rows>([&]<std::size_t r>() {
      for (std::size_t k = 0; k < n; ++k) {
        Real* pack = f + (r % width + r / width * edge) * row_length + k * lanes;
        min(T::load_unaligned(pack), least[r][k]).store_unaligned(pack);
      }
    });
  }
  /// 0, 1, 2, ..
  [[nodiscard]] static T counting() {
    std::array<Real, lanes> numbers;
    std::iota(numbers.begin(), numbers.end(), Real(0));
    return T::load_unaligned(numbers.data());
  }

  const Grid<Dim>& grid_;
  const CellOrder<Dim>& order_;
  std::array<const Real*, Dim> x_;
  Real inverse_dx_;
  Real* f_;
};

/// What lies outside of the domain along an axis.
template <int Dim, class Body> void each_outside(const Grid<Dim>& grid, int axis, Body&& body) {
  for (const Box<Dim>& slab : outside(grid, axis)) each_in(grid, slab, body);
}

/// Beyond a wall nobody asks how far it is from the liquid.
template <int Dim, class Real>
void settle_behind_walls(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, Field<Real>& f) {
  for (int d = 0; d < Dim; ++d)
    if (!walls.periodic(d)) each_outside(grid, d, [&](const Index<Dim>&, std::size_t at) { f[at] = 0; });
}

/// f(image) <- min(f(image), f) for what lies beyond the periodic sides.
template <int Dim, class Real> void fold_minimum(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, Field<Real>& f) {
  for (int d = 0; d < Dim; ++d)
    if (walls.periodic(d))
      each_outside(grid, d, [&](const Index<Dim>& i, std::size_t at) {
        Real& home = f[static_cast<std::size_t>(grid.at(walls.image(i)))];
        home = std::min(home, f[at]);
      });
}

/// f <- dx sqrt(f) - r
template <class Real> void to_distance(Real dx, Real r, Real* f, std::int64_t count) {
  using T = Pack<Real>;
  constexpr auto lanes = static_cast<std::int64_t>(lanes_of<T>);
  std::int64_t n = 0;
  for (; n + lanes <= count; n += lanes) (T(dx) * sqrt(T::load_unaligned(f + n)) - T(r)).store_unaligned(f + n);
  for (; n < count; ++n) f[n] = dx * std::sqrt(f[n]) - r;
}

} // namespace

template <int Dim> double particle_radius(double dx, int per_axis) {
  return (std::sqrt(Dim) + std::sqrt(Dim + 8)) / 4 * dx / per_axis;
}

template <int Dim, class Real>
void level_set(const Grid<Dim>& grid, const Walls<Dim, Real>& walls, const Particles<Dim, Real>& particles,
               const CellOrder<Dim>& order, double radius, Field<Real>& phi, Pool& pool) {
  const auto samples = static_cast<std::int64_t>(grid.size());
  phi.resize(static_cast<std::size_t>(samples));
  pool.ranges(samples, samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
    std::fill(phi.begin() + begin, phi.begin() + end, Real(far));
  });
  settle_behind_walls(grid, walls, phi);
  const NearestParticle<Dim, Real> nearest(grid, particles, order, phi);
  each_block_at_once(grid, pool, [&](const Index<Dim>& block) { nearest.own(block); });
  each_block(grid, pool, [&](const Index<Dim>& block) { nearest.others(block); });
  fold_minimum(grid, walls, phi);
  pool.ranges(samples, samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
    to_distance(static_cast<Real>(grid.dx), static_cast<Real>(radius), phi.data() + begin, end - begin);
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
