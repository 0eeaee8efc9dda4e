// SPDX-License-Identifier: MIT
#include "sim/transfer/transfer.h"

#include "sim/transfer/lanes.h"
#include "sim/transfer/scalar_sweep.h"
#include "sim/transfer/sweep.h"

#include <algorithm>

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 12;

/// Reads fields at packs of particles and writes the particles' columns.
template <class Mode, class K, int Dim, class Real> struct Gatherer {
  using T = Pack<Real>;
  using State = decltype(Mode::state);
  static constexpr std::size_t state_size = std::tuple_size_v<State>;

  Walk<Dim, Real> walk;
  Corner corner;
  std::array<const Real*, Dim> x;
  std::array<Real*, Dim> v;
  std::array<Real*, state_size> A;
  const std::uint8_t* ballistic;

  Gatherer(const Corner& c, Layout layout, const Grid<Dim>& grid, Particles<Dim, Real>& particles,
           const std::vector<std::uint8_t>* skip)
      : walk(grid, layout), corner(c), x(pointers<Dim>(std::as_const(particles.x))), v(pointers<Dim>(particles.v)),
        A(pointers<state_size>(particles.A)), ballistic(skip ? skip->data() : nullptr) {}

  /// sum w u and its first sums for every component, from one stencil.
  using Fields = std::array<const Real*, Dim>;
  [[nodiscard]] auto gather(const auto& stencil, const Fields& u) const {
    std::array<decltype(stencil.gather(walk, 0, u[0])), Dim> sums;
    for (int a = 0; a < Dim; ++a)
      sums[static_cast<std::size_t>(a)] = stencil.gather(walk, a, u[static_cast<std::size_t>(a)]);
    return sums;
  }

  /// affine * (what the mode gathers).
  [[nodiscard]] State affine_state(const auto& stencil, const auto& sums) const {
    Mode mode;
    mode.gather(stencil, sums, walk.inverse_dx);
    if constexpr (Mode::mode == AffineMode::full)
      if (corner.skew) mode.keep_skew();
    for (T& s : mode.state) s *= T(static_cast<Real>(corner.affine));
    return mode.state;
  }

  /// body(lanes, stencil) for every pack in which not all are ballistic.
  template <class Body> void each(std::size_t count, Pool& pool, Body&& body) const {
    pool.ranges(static_cast<std::int64_t>(count), particles_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      const auto last = static_cast<std::size_t>(end);
      for (auto p = static_cast<std::size_t>(begin); p < last; p += lanes_of<T>) {
        const Lanes<Real> lanes(p, last - p, ballistic);
        if (lanes.all_skipped()) continue;
        body(lanes, Stencil<K, Dim, T, typename Mode::Second>(
                        walk, walk.position([&](std::size_t d) { return lanes.read(x[d]); })));
      }
    });
  }
};

/// body(gatherer) with the gatherer for this corner and kernel.
template <int Dim, class Real, class Body>
void with_gatherer(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                   Particles<Dim, Real>& particles, const std::vector<std::uint8_t>* ballistic, Body&& body) {
  with_sweep(corner, kernel, particles, [&](auto mode, auto k) {
    body(Gatherer<decltype(mode), decltype(k), Dim, Real>(corner, layout, grid, particles, ballistic));
  });
}

} // namespace

template <int Dim, class Real>
void g2p(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid, const Components<Dim, Real>& u,
         const Components<Dim, Real>& u_old, Particles<Dim, Real>& particles, Pool& pool,
         const std::vector<std::uint8_t>* ballistic) {
  if (corner.scalar) return scalar_g2p(Take::all, corner, kernel, layout, grid, u, u_old, particles, pool, ballistic);
  const auto now = pointers<Dim>(u), before = pointers<Dim>(u_old);
  with_gatherer(corner, kernel, layout, grid, particles, ballistic, [&](const auto& to) {
    using T = Pack<Real>;
    const T flip_ratio(static_cast<Real>(corner.flip_ratio));
    to.each(particles.size(), pool, [=, &corner, &to](const auto& lanes, const auto& stencil) {
      const auto sums = to.gather(stencil, now);
      for (std::size_t a = 0; a < Dim; ++a) {
        T v = sums[a].value;
        if (corner.flip_ratio != 0) {
          // In this order v_p comes back unchanged, to the bit, where the grid did nothing and flip_ratio is 1.
          const T old = stencil.value(to.walk, static_cast<int>(a), before[a]);
          v = (v - flip_ratio * old) + flip_ratio * lanes.read(to.v[a]);
        }
        lanes.write(v, to.v[a]);
      }
      const auto state = to.affine_state(stencil, sums);
      for (std::size_t c = 0; c < state.size(); ++c) lanes.write(state[c], to.A[c]);
    });
  });
}

template <int Dim, class Real>
void g2p_increment(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                   const Components<Dim, Real>& du, Particles<Dim, Real>& particles, Pool& pool,
                   const std::vector<std::uint8_t>* ballistic) {
  if (corner.scalar)
    return scalar_g2p(Take::increment, corner, kernel, layout, grid, du, du, particles, pool, ballistic);
  const auto change = pointers<Dim>(du);
  with_gatherer(corner, kernel, layout, grid, particles, ballistic, [&](const auto& to) {
    to.each(particles.size(), pool, [=, &to](const auto& lanes, const auto& stencil) {
      const auto sums = to.gather(stencil, change);
      for (std::size_t a = 0; a < Dim; ++a) lanes.write(lanes.read(to.v[a]) + sums[a].value, to.v[a]);
      const auto state = to.affine_state(stencil, sums);
      for (std::size_t c = 0; c < state.size(); ++c) lanes.write(lanes.read(to.A[c]) + state[c], to.A[c]);
    });
  });
}

template <int Dim, class Real>
void gather_affine(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                   const Components<Dim, Real>& u, Particles<Dim, Real>& particles, Pool& pool) {
  if (corner.scalar) return scalar_g2p(Take::memory, corner, kernel, layout, grid, u, u, particles, pool, nullptr);
  const auto now = pointers<Dim>(u);
  with_gatherer(corner, kernel, layout, grid, particles, nullptr, [&](const auto& to) {
    to.each(particles.size(), pool, [=, &to](const auto& lanes, const auto& stencil) {
      const auto state = to.affine_state(stencil, to.gather(stencil, now));
      for (std::size_t c = 0; c < state.size(); ++c) lanes.write(state[c], to.A[c]);
    });
  });
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template void g2p(const Corner&, KernelName, Layout, const Grid<Dim>&, const Components<Dim, Real>&,                 \
                    const Components<Dim, Real>&, Particles<Dim, Real>&, Pool&, const std::vector<std::uint8_t>*);     \
  template void g2p_increment(const Corner&, KernelName, Layout, const Grid<Dim>&, const Components<Dim, Real>&,       \
                              Particles<Dim, Real>&, Pool&, const std::vector<std::uint8_t>*);                         \
  template void gather_affine(const Corner&, KernelName, Layout, const Grid<Dim>&, const Components<Dim, Real>&,       \
                              Particles<Dim, Real>&, Pool&)
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
