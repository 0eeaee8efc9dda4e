// SPDX-License-Identifier: MIT
#include "app/figures/single_transfer.h"

#include "sim/core/order.h"
#include "sim/transfer/stencil.h"
#include "sim/transfer/transfer.h"

namespace flipbook::app {

namespace {

/// The samples around the particle, in the order of the components and then of the rows.
template <class K>
std::vector<TouchedSample> touched(const Grid<2>& grid, Layout layout, const Vec<2, double>& x,
                                   const Components<2, double>& u) {
  const Walk<2, double> walk(grid, layout);
  const Stencil<K, 2, double> stencil(walk, walk.position([&](std::size_t d) { return x[static_cast<int>(d)]; }));
  std::vector<TouchedSample> samples;
  for (int a = 0; a < 2; ++a) {
    const Vec<2, double> origin = component_origin<2, double>(layout, a);
    const auto base = stencil.base(a);
    for (int j = 0; j < K::support; ++j)
      for (int i = 0; i < K::support; ++i) {
        const Index<2> at(static_cast<int>(base[0]) + i, static_cast<int>(base[1]) + j);
        const auto axes = std::array{static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
        samples.push_back({a, at[0] - Grid<2>::pad + origin[0], at[1] - Grid<2>::pad + origin[1],
                           stencil.axis(a, 0).w[axes[0]] * stencil.axis(a, 1).w[axes[1]],
                           u[static_cast<std::size_t>(a)][static_cast<std::size_t>(grid.at(at))]});
      }
  }
  return samples;
}

} // namespace

std::vector<TouchedSample> gather_and_paint(const Corner& corner, KernelName kernel, Layout layout, double x, double y,
                                            const GridVelocity& velocity, Pool& pool) {
  Grid<2> grid; // with cells of 1
  grid.cells = Index<2>(6, 6);
  Components<2, double> u, m, painted;
  for (auto* f : {&u, &m, &painted}) f->resize(grid);
  for (int a = 0; a < 2; ++a) {
    const Vec<2, double> origin = component_origin<2, double>(layout, a);
    for (std::ptrdiff_t k = 0; k < grid.size(); ++k) {
      const Vec<2, double> at = grid.index(k).cast<double>() + origin;
      u[static_cast<std::size_t>(a)][static_cast<std::size_t>(k)] =
          velocity(a, at[0] - Grid<2>::pad, at[1] - Grid<2>::pad);
    }
  }
  Particles<2, double> particle;
  particle.set_mode(corner.mode);
  const Vec<2, double> place(x, y);
  particle.add(place, Vec<2, double>::Zero(), 1, 0);
  CellOrder<2> order;
  sort_by_cell(particle, grid, order, pool);
  g2p(corner, kernel, layout, grid, u, u, particle, pool);
  p2g(corner, kernel, layout, grid, particle, order, m, painted, pool);
  to_velocity(m, painted, pool);
  return with_kernel(kernel, [&](auto k) {
    std::vector<TouchedSample> samples = touched<decltype(k)>(grid, layout, place, u);
    const std::vector<TouchedSample> after = touched<decltype(k)>(grid, layout, place, painted);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i].painted = after[i].u;
    return samples;
  });
}

double energy_kept(const std::vector<TouchedSample>& samples) {
  double kept = 0, all = 0;
  for (const TouchedSample& s : samples) {
    kept += s.weight * s.painted * s.painted;
    all += s.weight * s.u * s.u;
  }
  return kept / all;
}

} // namespace flipbook::app
