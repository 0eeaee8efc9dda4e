// SPDX-License-Identifier: MIT
#include "sim/diagnostics/ledger.h"

#include "sim/core/cross.h"
#include "sim/transfer/modes.h"
#include "sim/transfer/sweep.h"

#include <algorithm>

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 12;
constexpr std::int64_t rows_per_chunk = 64;

/// Sums side by side, which a processor adds up at once, in an order that no compiler changes.
struct Lanes {
  static constexpr std::size_t count = 4;
  std::array<double, count> sum{};
  [[nodiscard]] double total() const { return (sum[0] + sum[1]) + (sum[2] + sum[3]); }
};

/// body<0>(), body<1>(), .. body<N - 1>(): nothing is left of the loop, and compilers work on several particles at
/// once.
template <int N, class Body> void unrolled(Body&& body) {
  [&]<int... I>(std::integer_sequence<int, I...>) {
    (body.template operator()<I>(), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// Totals of a run of particles: each one's share by its mass, as columns, then their sums.
template <class Mode, class K, int Dim, class Real> struct ParticleSums {
  static constexpr std::size_t batch = 64;
  static constexpr std::size_t columns = std::tuple_size_v<decltype(Mode::state)>;
  using Column = std::array<double, batch>;
  using Moments = std::array<double, Dim>;

  Walk<Dim, Real> walk;
  double dx;
  Vec<Dim, double> origin;
  std::array<const Real*, Dim> x, v;
  std::array<const Real*, columns> A;
  const Real* mass;

  /// At most `batch` particles.
  void add(std::size_t begin, std::size_t n, Totals<Dim>& sum) const {
    std::array<Column, spin<Dim>> angular;
    Column energy;
    for (std::size_t l = 0; l < n; ++l) {
      Shares share;
      add_motion(begin + l, share);
      if constexpr (Mode::mode != AffineMode::none) add_affine(begin + l, share);
      energy[l] = share.twice_energy / 2;
      unrolled<spin<Dim>>([&]<int c>() { angular[c][l] = share.angular[c]; });
    }
    sum.mass += weighted(begin, n, [](std::size_t) { return 1.0; });
    unrolled<Dim>([&]<int a>() {
      sum.momentum[a] += weighted(begin, n, [&](std::size_t l) { return number(v[a], begin + l); });
      sum.first_moment[a] += weighted(begin, n, [&](std::size_t l) { return number(x[a], begin + l); });
    });
    unrolled<spin<Dim>>(
        [&]<int c>() { sum.angular_momentum[c] += weighted(begin, n, [&](std::size_t l) { return angular[c][l]; }); });
    sum.kinetic_energy += weighted(begin, n, [&](std::size_t l) { return energy[l]; });
  }

private:
  struct Shares {
    std::array<double, spin<Dim>> angular{};
    double twice_energy = 0;
  };
  static double number(const Real* column, std::size_t p) { return static_cast<double>(column[p]); }

  void add_motion(std::size_t p, Shares& share) const {
    Moments arm, u;
    unrolled<Dim>([&]<int d>() {
      arm[d] = number(x[d], p) - origin[d];
      u[d] = number(v[d], p);
      share.twice_energy += u[d] * u[d];
    });
    unrolled<Dim>([&]<int d>() {
      unrolled<Dim>([&]<int a>() {
        if constexpr (a != d) share.angular[cross_axis<Dim>(d, a)] += cross_sign<Dim>(d, a) * (arm[d] * u[a]);
      });
    });
  }

  /// What the affine modes add; momentum they have none. Products of axes carry energy only.
  void add_affine(std::size_t p, Shares& share) const {
    Moments own, other; // D on axis d, of component d and of the others, as in stencil.h
    unrolled<Dim>([&]<int d>() {
      const Real q = grid_position(x[d][p], walk.inverse_dx);
      own[d] = second_moment(q);
      other[d] = second_moment(q - walk.offset);
    });
    unrolled<Dim>([&]<int a>() {
      unrolled<Dim>([&]<int d>() {
        if constexpr (Mode::mode == AffineMode::rigid && a == d) return;
        const double g = slope<a, d>(p), Dg = (a == d ? own : other)[d] * g;
        share.twice_energy += Dg * g;
        if constexpr (a != d) share.angular[cross_axis<Dim>(d, a)] += cross_sign<Dim>(d, a) * Dg;
      });
      if constexpr (Mode::mode == AffineMode::polynomial) add_products<a>(p, own, other, share);
    });
  }

  template <int a> void add_products(std::size_t p, const Moments& own, const Moments& other, Shares& share) const {
    unrolled<(1 << Dim)>([&]<int s>() {
      if constexpr ((s & (s - 1)) != 0) {
        const double c = number(A[static_cast<std::size_t>(a * ((1 << Dim) - 1) + s - 1)], p);
        double product = c * c;
        unrolled<Dim>([&]<int d>() {
          if constexpr ((s >> d & 1) != 0) product *= (a == d ? own : other)[d];
        });
        share.twice_energy += product;
      }
    });
  }

  /// Mode::slope(a, d).
  template <int a, int d> [[nodiscard]] double slope(std::size_t p) const {
    if constexpr (Mode::mode == AffineMode::rigid)
      return cross_sign<Dim>(d, a) * number(A[static_cast<std::size_t>(cross_axis<Dim>(d, a))], p);
    else if constexpr (Mode::mode == AffineMode::full)
      return number(A[static_cast<std::size_t>(a * Dim + d)], p);
    else
      return number(A[static_cast<std::size_t>(a * ((1 << Dim) - 1) + (1 << d) - 1)], p);
  }

  /// D at q of a lattice with origin 0, m^2; the fraction is the one that the transfers round to.
  [[nodiscard]] double second_moment(Real q) const {
    return dx * dx * K::second_moment(static_cast<double>(q - K::base(q)));
  }

  /// sum m value.
  template <class Value> [[nodiscard]] double weighted(std::size_t begin, std::size_t n, Value&& value) const {
    Lanes s;
    std::size_t l = 0;
    for (; l + Lanes::count <= n; l += Lanes::count)
      for (std::size_t k = 0; k < Lanes::count; ++k) s.sum[k] += number(mass, begin + l + k) * value(l + k);
    for (; l < n; ++l) s.sum[0] += number(mass, begin + l) * value(l);
    return s.total();
  }
};

} // namespace

template <int Dim> Totals<Dim>& Totals<Dim>::operator+=(const Totals& other) {
  mass += other.mass;
  momentum += other.momentum;
  first_moment += other.first_moment;
  angular_momentum += other.angular_momentum;
  kinetic_energy += other.kinetic_energy;
  return *this;
}

template <int Dim, class Real>
Totals<Dim> particle_totals(KernelName kernel, Layout layout, const Grid<Dim>& grid,
                            const Particles<Dim, Real>& particles, const Vec<Dim, double>& origin, Pool& pool,
                            const std::vector<std::uint8_t>* only) {
  const auto range = [&](auto mode, auto k, std::size_t begin, std::size_t end) {
    using Mode = decltype(mode);
    using Sums = ParticleSums<Mode, decltype(k), Dim, Real>;
    const Sums sums{{grid, layout},
                    grid.dx,
                    origin,
                    pointers<Dim>(particles.x),
                    pointers<Dim>(particles.v),
                    pointers<std::tuple_size_v<decltype(Mode::state)>>(particles.A),
                    particles.m.data()};
    Totals<Dim> sum;
    if (!only)
      for (std::size_t p = begin; p < end; p += Sums::batch) sums.add(p, std::min(Sums::batch, end - p), sum);
    else
      for (std::size_t p = begin; p < end; ++p)
        if ((*only)[p]) sums.add(p, 1, sum);
    return sum;
  };
  return with_mode<Dim, Real>(particles.mode, [&](auto mode) {
    return with_kernel(kernel, [&](auto k) {
      return pool.sum(static_cast<std::int64_t>(particles.size()), particles_per_chunk, Totals<Dim>(),
                      [&](std::int64_t begin, std::int64_t end) {
                        return range(mode, k, static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
                      });
    });
  });
}

namespace {

/// sum m, m u, m u^2 and i m u along a stretch of a row of samples.
struct RowSums {
  Lanes m, mu, muu, imu;

  template <class Real> void add(const Real* mass, const Real* velocity, int begin, int end) {
    constexpr auto step = static_cast<int>(Lanes::count);
    int i = begin;
    for (; i + step <= end; i += step)
      for (int l = 0; l < step; ++l) add(static_cast<std::size_t>(l), mass[i + l], velocity[i + l], i + l);
    for (; i < end; ++i) add(0, mass[i], velocity[i], i);
  }

private:
  template <class Real> void add(std::size_t lane, Real mass, Real velocity, int i) {
    const double a = static_cast<double>(mass), u = static_cast<double>(velocity), au = a * u;
    m.sum[lane] += a;
    mu.sum[lane] += au;
    muu.sum[lane] += au * u;
    imu.sum[lane] += i * au;
  }
};

} // namespace

template <int Dim, class Real>
void Stretches<Dim, Real>::find(const Grid<Dim>& grid, const Components<Dim, Real>& m, Pool& pool) {
  const int length = grid.extent()[0];
  const auto rows = static_cast<std::size_t>(grid.size() / length);
  for (std::size_t a = 0; a < Dim; ++a) {
    of[a].resize(rows);
    pool.ranges(static_cast<std::int64_t>(rows), rows_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t row = begin; row < end; ++row) {
        const Real* mass = m[a].data() + row * length;
        int first = 0, last = length;
        while (first < last && !(mass[first] > 0)) ++first;
        while (last > first && !(mass[last - 1] > 0)) --last;
        of[a][static_cast<std::size_t>(row)] = {first, last};
      }
    });
  }
}

template <int Dim, class Real>
Totals<Dim> grid_totals(Layout layout, const Grid<Dim>& grid, const Components<Dim, Real>& m,
                        const Components<Dim, Real>& u, const Vec<Dim, double>& origin, Pool& pool,
                        const std::array<bool, static_cast<std::size_t>(Dim)>& periodic,
                        const Stretches<Dim, Real>* stretches) {
  const Index<Dim> extent = grid.extent();
  Index<Dim> lo = Index<Dim>::Zero(), hi = extent;
  for (int d = 0; d < Dim; ++d)
    if (periodic[static_cast<std::size_t>(d)]) lo[d] = Grid<Dim>::pad, hi[d] = Grid<Dim>::pad + grid.cells[d];
  const auto add_row = [&](int a, const Index<Dim>& i, Totals<Dim>& sum) {
    const auto c = static_cast<std::size_t>(a);
    const std::ptrdiff_t row = grid.at(i);
    RowSums s;
    int begin = lo[0], end = hi[0];
    if (stretches) {
      const auto& [first, last] = stretches->of[c][static_cast<std::size_t>(row / extent[0])];
      begin = std::max(begin, first), end = std::min(end, last);
      if (begin >= end) return;
    }
    s.add(m[c].data() + row, u[c].data() + row, begin, end);
    const double momentum = s.mu.total();
    sum.mass += s.m.total() / Dim;
    sum.momentum[a] += momentum;
    sum.kinetic_energy += s.muu.total() / 2;
    const Vec<Dim, double> lattice = component_origin<Dim, double>(layout, a);
    for (int d = 0; d < Dim; ++d) {
      if (d == a) continue;
      const double first = grid.dx * ((i[d] - Grid<Dim>::pad) + lattice[d]) - origin[d]; // of x_d - origin in the row
      const double moment = first * momentum + (d == 0 ? grid.dx * s.imu.total() : 0.0);
      sum.angular_momentum[cross_axis<Dim>(d, a)] += cross_sign<Dim>(d, a) * moment;
    }
  };
  return pool.sum(grid.size() / extent[0], rows_per_chunk, Totals<Dim>(), [&](std::int64_t begin, std::int64_t end) {
    Totals<Dim> part;
    for (std::int64_t row = begin; row < end; ++row) {
      Index<Dim> i = Index<Dim>::Zero();
      bool counted = true;
      std::int64_t rest = row;
      for (int d = 1; d < Dim; rest /= extent[d], ++d) {
        i[d] = static_cast<int>(rest % extent[d]);
        counted = counted && i[d] >= lo[d] && i[d] < hi[d];
      }
      for (int a = 0; counted && a < Dim; ++a) add_row(a, i, part);
    }
    return part;
  });
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template Totals<Dim> particle_totals(KernelName, Layout, const Grid<Dim>&, const Particles<Dim, Real>&,              \
                                       const Vec<Dim, double>&, Pool&, const std::vector<std::uint8_t>*);              \
  template Totals<Dim> grid_totals(                                                                                    \
      Layout, const Grid<Dim>&, const Components<Dim, Real>&, const Components<Dim, Real>&, const Vec<Dim, double>&,   \
      Pool&, const std::array<bool, static_cast<std::size_t>(Dim)>&, const Stretches<Dim, Real>*);                     \
  template struct Stretches<Dim, Real>
template struct Totals<2>;
template struct Totals<3>;
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
