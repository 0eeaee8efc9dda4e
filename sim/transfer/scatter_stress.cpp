// SPDX-License-Identifier: MIT
#include "sim/transfer/scatter_stress.h"

#include "sim/transfer/clear.h"
#include "sim/transfer/lanes.h"
#include "sim/transfer/painted.h"
#include "sim/transfer/sweep.h"

#include <type_traits>

namespace flipbook {
namespace {

/// f_i -= V0 tau g_i for the particles of a block, on its tile.
template <class Second, class K, int Dim, class Real> struct ScatterStress {
  using T = Pack<Real>;
  using Mode = StressMode<Dim, T, Second>;

  Walk<Dim, Real> walk;
  std::array<const Real*, Dim> x;
  StressColumns<Dim, Real> stress;
  std::size_t size; ///< of all particles

  /// The particles [begin, end).
  void operator()(Tile<K, Dim, Real>& tile, std::size_t begin, std::size_t end) const {
    std::array<Painted<Mode, K, Dim, Real>, Dim> painted;
    const T factor(-walk.inverse_dx); // second weights are in cells
    for (std::size_t p = begin; p < end; p += Lanes<Real>::count) {
      const Lanes<Real> lanes(p, end - p, nullptr);
      // Others may fill the pack up.
      const auto read = [&](const Real* column) { return load<T>(column + p, size - p); };
      const auto q = walk.position([&](std::size_t d) { return read(x[d]); });
      const Stencil<K, Dim, T, Second> stencil(walk, q);
      Mode mode;
      for (std::size_t c = 0; c < stress.size(); ++c) mode.state[c] = factor * read(stress[c]);
      for (std::size_t a = 0; a < Dim; ++a) painted[a].paint(stencil, static_cast<int>(a), whole(q[0]), mode, tile);
      lanes.each([&](std::size_t l) {
        for (std::size_t a = 0; a < Dim; ++a) painted[a].add(l, tile.data(a));
      });
    }
  }
};

} // namespace

template <int Dim, class Real>
void scatter_stress(Through through, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                    const Particles<Dim, Real>& particles, const StressColumns<Dim, Real>& stress,
                    const CellOrder<Dim>& order, Components<Dim, Real>& f, Pool& pool) {
  clear(f, pool);
  with_kernel(kernel, [&](auto k) {
    using K = decltype(k);
    const auto sweep = [&]<class Second>(Second) {
      const ScatterStress<Second, K, Dim, Real> scatter{
          {grid, layout}, pointers<Dim>(particles.x), stress, particles.size()};
      each_block(grid, pool, [&](const Index<Dim>& first) {
        const auto [begin, end] = order.block(first);
        if (begin == end) return;
        Tile<K, Dim, Real> tile(first);
        scatter(tile, begin, end);
        tile.add_first_to(grid, f);
      });
    };
    if (through == Through::gradient || std::is_same_v<K, Linear>) // of which both forms are one
      sweep(Slopes{});
    else
      sweep(AffineWeights{});
  });
}

#define FLIPBOOK_SCATTER_STRESS(Dim, Real)                                                                             \
  template void scatter_stress(Through, KernelName, Layout, const Grid<Dim>&, const Particles<Dim, Real>&,             \
                               const StressColumns<Dim, Real>&, const CellOrder<Dim>&, Components<Dim, Real>&, Pool&);
FLIPBOOK_SCATTER_STRESS(2, float)
FLIPBOOK_SCATTER_STRESS(2, double)
FLIPBOOK_SCATTER_STRESS(3, float)
FLIPBOOK_SCATTER_STRESS(3, double)
#undef FLIPBOOK_SCATTER_STRESS

} // namespace flipbook
