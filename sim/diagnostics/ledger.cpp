// SPDX-License-Identifier: MIT
#include "sim/diagnostics/ledger.h"

#include "sim/core/cross.h"
#include "sim/transfer/modes.h"
#include "sim/transfer/sweep.h"

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 12;
constexpr std::int64_t rows_per_chunk = 64;

/// What a particle's affine mode adds to angular momentum and energy; momentum it has none. Products of axes carry
/// energy only: m/2 c^2 prod D.
template <int Dim, class Stencil, class Mode>
void add_affine(const Stencil& stencil, const Mode& mode, double dx, double mass, Totals<Dim>& sum) {
  for (int a = 0; a < Dim; ++a)
    for (int d = 0; d < Dim; ++d) {
      const double D = stencil.second_moment(a, d) * dx * dx, g = static_cast<double>(mode.slope(a, d));
      sum.kinetic_energy += mass / 2 * D * g * g;
      if (a != d) sum.angular_momentum[cross_axis<Dim>(d, a)] += mass * cross_sign<Dim>(d, a) * D * g;
    }
  if constexpr (Mode::mode == AffineMode::polynomial)
    for (int a = 0; a < Dim; ++a)
      for (unsigned s = 3; s <= Mode::sets; ++s) {
        if ((s & (s - 1)) == 0) continue;
        const auto c = static_cast<double>(mode.coefficient(a, s));
        double energy = mass / 2 * c * c;
        for (int d = 0; d < Dim; ++d)
          if ((s >> d & 1U) != 0) energy *= stencil.second_moment(a, d) * dx * dx;
        sum.kinetic_energy += energy;
      }
}

} // namespace

template <int Dim> Totals<Dim>& Totals<Dim>::operator+=(const Totals& other) {
  mass += other.mass;
  momentum += other.momentum;
  angular_momentum += other.angular_momentum;
  kinetic_energy += other.kinetic_energy;
  return *this;
}

template <int Dim, class Real>
Totals<Dim> particle_totals(KernelName kernel, Layout layout, const Grid<Dim>& grid,
                            const Particles<Dim, Real>& particles, const Vec<Dim, double>& origin, Pool& pool) {
  const Walk<Dim, double> walk(grid, layout);
  const auto range = [&](auto mode, auto k, std::int64_t begin, std::int64_t end) {
    using Mode = decltype(mode);
    const auto A = pointers<std::tuple_size_v<decltype(Mode::state)>>(particles.A);
    Totals<Dim> sum;
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
      const Vec<Dim, double> x = particles.position(p).template cast<double>();
      const Vec<Dim, double> v = particles.velocity(p).template cast<double>();
      const auto mass = static_cast<double>(particles.m[p]);
      sum.mass += mass;
      sum.momentum += mass * v;
      sum.angular_momentum += mass * cross<Dim, double>(x - origin, v);
      sum.kinetic_energy += mass / 2 * v.squaredNorm();
      const Stencil<decltype(k), Dim, double> stencil(
          walk, walk.position([&](std::size_t d) { return x[static_cast<Eigen::Index>(d)]; }));
      add_affine(stencil, Mode{entries(A, p)}, grid.dx, mass, sum);
    }
    return sum;
  };
  return with_mode<Dim, Real>(particles.mode, [&](auto mode) {
    return with_kernel(kernel, [&](auto k) {
      return pool.sum(static_cast<std::int64_t>(particles.size()), particles_per_chunk, Totals<Dim>(),
                      [&](std::int64_t begin, std::int64_t end) { return range(mode, k, begin, end); });
    });
  });
}

template <int Dim, class Real>
Totals<Dim> grid_totals(Layout layout, const Grid<Dim>& grid, const Components<Dim, Real>& m,
                        const Components<Dim, Real>& u, const Vec<Dim, double>& origin, Pool& pool,
                        const std::array<bool, static_cast<std::size_t>(Dim)>& periodic) {
  const Index<Dim> extent = grid.extent();
  const auto counted = [&](int d, int i) {
    return !periodic[static_cast<std::size_t>(d)] || (i >= Grid<Dim>::pad && i < Grid<Dim>::pad + grid.cells[d]);
  };
  const auto add_row = [&](int a, Index<Dim> i, Totals<Dim>& sum) {
    for (int d = 1; d < Dim; ++d)
      if (!counted(d, i[d])) return;
    const Vec<Dim, double> lattice = component_origin<Dim, double>(layout, a);
    for (i[0] = 0; i[0] < extent[0]; ++i[0]) {
      const auto k = static_cast<std::size_t>(grid.at(i));
      const auto c = static_cast<std::size_t>(a);
      if (!counted(0, i[0]) || !(m[c][k] > 0)) continue;
      const double mass = static_cast<double>(m[c][k]), velocity = static_cast<double>(u[c][k]);
      const Vec<Dim, double> x =
          grid.dx * ((i.array() - Grid<Dim>::pad).template cast<double>() + lattice.array()).matrix() - origin;
      sum.mass += mass / Dim;
      sum.momentum[a] += mass * velocity;
      sum.kinetic_energy += mass / 2 * velocity * velocity;
      for (int d = 0; d < Dim; ++d)
        if (d != a) sum.angular_momentum[cross_axis<Dim>(d, a)] += cross_sign<Dim>(d, a) * x[d] * mass * velocity;
    }
  };
  return pool.sum(grid.size() / extent[0], rows_per_chunk, Totals<Dim>(), [&](std::int64_t begin, std::int64_t end) {
    Totals<Dim> sum;
    for (std::int64_t row = begin; row < end; ++row) {
      Index<Dim> i = Index<Dim>::Zero();
      std::int64_t rest = row;
      for (int d = 1; d < Dim; rest /= extent[d], ++d) i[d] = static_cast<int>(rest % extent[d]);
      for (int a = 0; a < Dim; ++a) add_row(a, i, sum);
    }
    return sum;
  });
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template Totals<Dim> particle_totals(KernelName, Layout, const Grid<Dim>&, const Particles<Dim, Real>&,              \
                                       const Vec<Dim, double>&, Pool&);                                                \
  template Totals<Dim> grid_totals(Layout, const Grid<Dim>&, const Components<Dim, Real>&,                             \
                                   const Components<Dim, Real>&, const Vec<Dim, double>&, Pool&,                       \
                                   const std::array<bool, static_cast<std::size_t>(Dim)>&)
template struct Totals<2>;
template struct Totals<3>;
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
