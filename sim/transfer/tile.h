// SPDX-License-Identifier: MIT
// What the particles of one block of cells leave on the samples around them, (m u, m) side by side. It stays in the
// nearest caches until the block is done, and is then added to the grid.
//
// Along x every cell has samples of its own, those that any of its particles reaches, on an address that registers
// like: all particles of a cell then write to the same addresses, and no write waits for one that overlaps it.
// Neighbouring cells are added up on the way to the grid.
#pragma once

#include "sim/core/field.h"
#include "sim/core/order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace flipbook {

template <class K, int Dim, class Real> class Tile {
public:
  static constexpr int before = K::support / 2;          ///< samples that stencils reach ahead of their cell
  static constexpr int edge = block_edge + K::support;   ///< samples along the axes above x
  static constexpr std::size_t reached = K::support + 1; ///< along x: by all particles of a cell; each one misses one
  static constexpr std::size_t slot = 2 * std::bit_ceil(reached); ///< numbers of a cell: (m u, m) of each, and zeros

  /// The tile of the block with this first cell; everything is zero.
  explicit Tile(const Index<Dim>& first) : first_(first) {
    for (auto& s : sums_) s.fill(Real(0));
  }

  /// Of slots along x, and along the axes above it from one row of samples to the next.
  [[nodiscard]] static constexpr std::size_t stride(int axis) {
    return axis == 0 ? slot : slot * block_edge * power(edge, axis - 1);
  }
  /// Where slots are counted from on an axis: the block's first cell along x, the first sample reached on the others.
  [[nodiscard]] int origin(int axis) const { return axis == 0 ? first_[0] : first_[axis] - before; }
  [[nodiscard]] Real* data(std::size_t component) { return sums_[component].data(); }

  /// m += m, mu += m u, on the samples that the grid has.
  void add_to(const Grid<Dim>& grid, Components<Dim, Real>& m, Components<Dim, Real>& mu) const { add(grid, &m, mu); }
  /// The first of each pair alone: sums += m u.
  void add_first_to(const Grid<Dim>& grid, Components<Dim, Real>& sums) const { add(grid, nullptr, sums); }

private:
  void add(const Grid<Dim>& grid, Components<Dim, Real>* m, Components<Dim, Real>& mu) const {
    Index<Dim> begin = first_.array() - before;
    const Index<Dim> end = (begin.array() + edge).min(grid.extent().array());
    begin = begin.cwiseMax(0);
    for (Index<Dim> i = begin; i[Dim - 1] < end[Dim - 1];) {
      std::size_t row = 0;
      for (int d = 1; d < Dim; ++d) row += stride(d) * static_cast<std::size_t>(i[d] - origin(d));
      const auto to = static_cast<std::size_t>(grid.at(i));
      for (std::size_t a = 0; a < Dim; ++a)
        add_row(sums_[a].data() + row, begin[0] - (first_[0] - before), end[0] - begin[0],
                m ? (*m)[a].data() + to : nullptr, mu[a].data() + to);
      ++i[1];
      if constexpr (Dim == 3) {
        if (i[1] == end[1]) i[1] = begin[1], ++i[2];
      }
    }
  }

  /// `skip`: samples at the beginning that the grid does not have.
  static void add_row(const Real* slots, int skip, int length, Real* m, Real* mu) {
    constexpr std::size_t samples = block_edge + reached - 1;
    std::array<Real, 2 * samples> sum{};
    for (std::size_t c = 0; c < block_edge; ++c)
      for (std::size_t k = 0; k < 2 * reached; ++k) sum[2 * c + k] += slots[slot * c + k];
    const int many = std::min(length, static_cast<int>(samples) - skip);
    for (int i = 0; i < many; ++i) mu[i] += sum[2 * static_cast<std::size_t>(i + skip)];
    if (!m) return;
    for (int i = 0; i < many; ++i) m[i] += sum[2 * static_cast<std::size_t>(i + skip) + 1];
  }

  Index<Dim> first_;
  alignas(64) std::array<std::array<Real, slot * block_edge * power(edge, Dim - 1)>, Dim> sums_;
};

} // namespace flipbook
