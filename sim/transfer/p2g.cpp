// SPDX-License-Identifier: MIT
#include "sim/transfer/transfer.h"

#include "sim/transfer/scalar_sweep.h"
#include "sim/transfer/sweep.h"

namespace flipbook {
namespace {

constexpr std::int64_t samples_per_chunk = 1 << 15;

template <int Dim, class Real> void clear(Components<Dim, Real>& field, Pool& pool) {
  for (auto& f : field)
    pool.ranges(static_cast<std::int64_t>(f.size()), samples_per_chunk,
                [&](std::int64_t begin, std::int64_t end) { std::fill(f.begin() + begin, f.begin() + end, Real(0)); });
}

/// (m u)_i += w_ip m_p (v_p + A_p r) for the particles [begin, end).
template <class Mode, class K, int Dim, class Real> struct Scatter {
  Walk<Dim, Real> walk;
  std::array<const Real*, Dim> x, v;
  std::array<const Real*, std::tuple_size_v<decltype(Mode::state)>> A;
  const Real* mass;
  std::array<Real*, Dim> m, mu;
  const std::uint8_t* ballistic;

  void operator()(std::size_t begin, std::size_t end) const {
    for (std::size_t p = begin; p < end; ++p) {
      if (ballistic && ballistic[p]) continue;
      const Stencil<K, Dim, Real> stencil(walk, walk.position([&](std::size_t d) { return x[d][p]; }));
      const Mode mode{entries(A, p)};
      for (int a = 0; a < Dim; ++a) {
        const auto c = static_cast<std::size_t>(a);
        if constexpr (Mode::mode == AffineMode::polynomial) {
          std::array<Real, 1 << Dim> product;
          product[0] = v[c][p];
          for (unsigned s = 1; s < product.size(); ++s) {
            product[s] = mode.coefficient(a, s);
            for (unsigned rest = s; rest != 0; rest &= rest - 1) product[s] *= walk.dx;
          }
          stencil.scatter(walk, a, mass[p], product, m[c], mu[c]);
        } else {
          std::array<Real, Dim> slope;
          for (int d = 0; d < Dim; ++d) slope[static_cast<std::size_t>(d)] = mode.slope(a, d) * walk.dx;
          stencil.scatter(walk, a, mass[p], v[c][p], slope, m[c], mu[c]);
        }
      }
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
    const Scatter<Mode, decltype(k), Dim, Real> scatter{{grid, layout},
                                                        pointers<Dim>(particles.x),
                                                        pointers<Dim>(particles.v),
                                                        pointers<std::tuple_size_v<decltype(Mode::state)>>(particles.A),
                                                        particles.m.data(),
                                                        pointers<Dim>(m),
                                                        pointers<Dim>(mu),
                                                        ballistic ? ballistic->data() : nullptr};
    each_block(grid, order, pool, scatter);
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
