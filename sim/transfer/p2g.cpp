// SPDX-License-Identifier: MIT
#include "sim/transfer/transfer.h"

#include "sim/transfer/clear.h"
#include "sim/transfer/lanes.h"
#include "sim/transfer/painted.h"
#include "sim/transfer/scalar_sweep.h"
#include "sim/transfer/sweep.h"

#include <utility>

namespace flipbook {
namespace {

constexpr std::int64_t samples_per_chunk = 1 << 15;

/// (m u)_i += w_ip m_p (v_p + A_p r) for the particles of a block, on its tile.
template <class Mode, class K, int Dim, class Real> struct Scatter {
  using T = Pack<Real>;
  using Paint = Painted<Mode, K, Dim, Real>;

  Walk<Dim, Real> walk;
  std::array<const Real*, Dim> x, v;
  std::array<const Real*, std::tuple_size_v<decltype(Mode::state)>> A;
  const Real* mass;
  const std::uint8_t* ballistic;
  std::size_t size; ///< of all particles

  /// The particles [begin, end).
  void operator()(Tile<K, Dim, Real>& tile, std::size_t begin, std::size_t end) const {
    std::array<Paint, Dim> painted;
    for (std::size_t p = begin; p < end; p += Lanes<Real>::count) {
      const Lanes<Real> lanes(p, end - p, ballistic);
      if (lanes.all_skipped()) continue;
      const auto read = [&](const Real* column) {
        return load<T>(column + p, size - p);
      }; // others may fill the pack up
      const auto q = walk.position([&](std::size_t d) { return read(x[d]); });
      const Stencil<K, Dim, T> stencil(walk, q);
      Mode mode;
      for (std::size_t c = 0; c < A.size(); ++c) mode.state[c] = read(A[c]);
      const T m = read(mass);
      for (std::size_t a = 0; a < Dim; ++a)
        painted[a].paint(walk, stencil, static_cast<int>(a), whole(q[0]), m, read(v[a]), mode, tile);
      // Particle after particle, and of each all components: their sums do not wait for each other.
      const auto add = [&](std::size_t l) {
        for (std::size_t a = 0; a < Dim; ++a) painted[a].add(l, tile.data(a));
      };
      if (lanes.whole())
        for (std::size_t l = 0; l < Lanes<Real>::count; ++l) add(l);
      else
        lanes.each(add);
    }
  }
};

} // namespace

template <int Dim, class Real>
void p2g(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
         const Particles<Dim, Real>& particles, const CellOrder<Dim>& order, Components<Dim, Real>& m,
         Components<Dim, Real>& mu, Pool& pool, const std::vector<std::uint8_t>* ballistic) {
  clear(m, pool);
  clear(mu, pool);
  if (corner.scalar) return scalar_p2g(corner, kernel, layout, grid, particles, order, m, mu, pool, ballistic);
  with_sweep(corner, kernel, particles, [&](auto mode, auto k) {
    using Mode = decltype(mode);
    using K = decltype(k);
    const Scatter<Mode, K, Dim, Real> scatter{{grid, layout},
                                              pointers<Dim>(particles.x),
                                              pointers<Dim>(particles.v),
                                              pointers<std::tuple_size_v<decltype(Mode::state)>>(particles.A),
                                              particles.m.data(),
                                              ballistic ? ballistic->data() : nullptr,
                                              particles.size()};
    each_block(grid, pool, [&](const Index<Dim>& first) {
      const auto [begin, end] = order.block(first);
      if (begin == end) return;
      Tile<K, Dim, Real> tile(first);
      scatter(tile, begin, end);
      tile.add_to(grid, m, mu);
    });
  });
}

template <int Dim, class Real> void to_velocity(const Components<Dim, Real>& m, Components<Dim, Real>& mu, Pool& pool) {
  for (std::size_t a = 0; a < Dim; ++a)
    pool.ranges(static_cast<std::int64_t>(m[a].size()), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        mu[a][i] = m[a][i] > 0 ? mu[a][i] / m[a][i] : Real(0);
    });
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template void p2g(const Corner&, KernelName, Layout, const Grid<Dim>&, const Particles<Dim, Real>&,                  \
                    const CellOrder<Dim>&, Components<Dim, Real>&, Components<Dim, Real>&, Pool&,                      \
                    const std::vector<std::uint8_t>*);                                                                 \
  template void to_velocity(const Components<Dim, Real>&, Components<Dim, Real>&, Pool&)
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
