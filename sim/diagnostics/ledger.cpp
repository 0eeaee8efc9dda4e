// SPDX-License-Identifier: MIT
#include "sim/diagnostics/ledger.h"

#include "sim/core/cross.h"
#include "sim/core/pack.h"
#include "sim/core/unrolled.h"
#include "sim/transfer/modes.h"
#include "sim/transfer/sweep.h"

#include <algorithm>
#include <cstring>

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 12;
constexpr std::int64_t samples_per_chunk = 1 << 15;

/// Totals of particles, a pack in double at a time.
template <class Mode, int Dim, class Real> class ParticleSums {
public:
  static constexpr std::size_t columns = std::tuple_size_v<decltype(Mode::state)>;
  using T = Pack<double>;
  static constexpr std::size_t lanes = lanes_of<T>;

  ParticleSums(KernelName kernel, Layout layout, const Grid<Dim>& grid, const Vec<Dim, double>& origin,
               const Particles<Dim, Real>& particles, const std::uint8_t* only)
      : kernel_(kernel), walk_(grid, layout), dx_squared_(grid.dx * grid.dx), origin_(origin),
        x_(pointers<Dim>(particles.x)), v_(pointers<Dim>(particles.v)), A_(pointers<columns>(particles.A)),
        mass_(particles.m.data()), only_(only) {}

  /// The particles [begin, end); of them only those that are marked, where there are marks.
  [[nodiscard]] Totals<Dim> operator()(std::size_t begin, std::size_t end) const {
    Sums sums;
    std::size_t p = next(begin, begin, end);
    for (; p + lanes <= end; p = next(p + lanes, begin, end))
      add(p, std::integral_constant<std::size_t, lanes>(), sums);
    if (p < end) add(p, end - p, sums);
    return sums.totals();
  }

private:
  /// The pack at or after p with a particle that counts; packs begin at multiples of the lanes after `begin`.
  [[nodiscard]] std::size_t next(std::size_t p, std::size_t begin, std::size_t end) const {
    if (!only_ || p >= end) return p;
    const void* marked = std::memchr(only_ + p, 1, end - p);
    if (marked == nullptr) return end;
    const auto at = static_cast<std::size_t>(static_cast<const std::uint8_t*>(marked) - only_);
    return at - (at - begin) % lanes;
  }

  using Moments = std::array<T, Dim>;
  struct Sums {
    T mass = T(0), energy = T(0); ///< twice the energy
    Moments momentum, first_moment;
    std::array<T, spin<Dim>> angular;

    Sums() {
      momentum.fill(T(0));
      first_moment.fill(T(0));
      angular.fill(T(0));
    }
    [[nodiscard]] Totals<Dim> totals() const {
      Totals<Dim> t;
      t.mass = sum_of(mass);
      t.kinetic_energy = sum_of(energy) / 2;
      unrolled<Dim>([&]<int a>() {
        t.momentum[a] = sum_of(momentum[a]);
        t.first_moment[a] = sum_of(first_moment[a]);
      });
      unrolled<spin<Dim>>([&]<int c>() { t.angular_momentum[c] = sum_of(angular[c]); });
      return t;
    }
  };
  struct Shares { ///< of a unit of mass
    std::array<T, spin<Dim>> angular;
    T energy = T(0);
  };

  /// `many` is known to the compiler for all but the last pack.
  template <class Many> void add(std::size_t p, Many many, Sums& sums) const {
    const auto read = [&](const Real* column) { return load_in_double(column + p, many); };
    T m = read(mass_);
    if (many < lanes || only_) m = m * counted(p, many);
    Shares share;
    share.angular.fill(T(0));
    Moments x, v;
    unrolled<Dim>([&]<int d>() {
      x[d] = read(x_[d]);
      v[d] = read(v_[d]);
      share.energy += v[d] * v[d];
      sums.momentum[d] += m * v[d];
      sums.first_moment[d] += m * x[d];
    });
    unrolled<Dim>([&]<int d>() {
      const T arm = x[d] - T(origin_[d]);
      unrolled<Dim>([&]<int a>() {
        if constexpr (a != d) book<d, a>(arm * v[a], share);
      });
    });
    if constexpr (Mode::mode != AffineMode::none) add_affine(p, many, share);
    sums.mass += m;
    sums.energy += m * share.energy;
    unrolled<spin<Dim>>([&]<int c>() { sums.angular[c] += m * share.angular[c]; });
  }

  /// The part of e_d x e_a.
  template <int d, int a> static void book(const T& part, Shares& share) {
    T& sum = share.angular[static_cast<std::size_t>(cross_axis<Dim>(d, a))];
    sum = cross_sign<Dim>(d, a) > 0 ? sum + part : sum - part;
  }

  /// 1 in the lanes that count, 0 in the others.
  [[nodiscard]] T counted(std::size_t p, std::size_t many) const {
    std::array<double, lanes> one{};
    for (std::size_t l = 0; l < many; ++l) one[l] = !only_ || only_[p + l] ? 1 : 0;
    return T::load_unaligned(one.data());
  }

  /// What the affine modes add; momentum they have none. Products of axes carry energy only.
  template <class Many> void add_affine(std::size_t p, Many many, Shares& share) const {
    Moments own, other; // D on axis d, of component d and of the others, as in stencil.h
    with_kernel(kernel_, [&](auto kernel) {
      unrolled<Dim>([&]<int d>() {
        own[d] = second_moment(kernel, x_[d] + p, many, Real(0));
        other[d] = second_moment(kernel, x_[d] + p, many, walk_.offset);
      });
    });
    unrolled<Dim>([&]<int a>() {
      unrolled<Dim>([&]<int d>() {
        if constexpr (Mode::mode == AffineMode::rigid && a == d) return;
        const T g = slope<a, d>(p, many), Dg = (a == d ? own : other)[d] * g;
        share.energy += Dg * g;
        if constexpr (a != d) book<d, a>(Dg, share);
      });
      if constexpr (Mode::mode == AffineMode::polynomial) add_products<a>(p, many, own, other, share);
    });
  }

  template <int a, class Many>
  void add_products(std::size_t p, Many many, const Moments& own, const Moments& other, Shares& share) const {
    unrolled<(1 << Dim)>([&]<int s>() {
      if constexpr ((s & (s - 1)) != 0) {
        const T c = load_in_double(A_[static_cast<std::size_t>(a * ((1 << Dim) - 1) + s - 1)] + p, many);
        T product = c * c;
        unrolled<Dim>([&]<int d>() {
          if constexpr ((s >> d & 1) != 0) product *= (a == d ? own : other)[d];
        });
        share.energy += product;
      }
    });
  }

  /// Mode::slope(a, d).
  template <int a, int d, class Many> [[nodiscard]] T slope(std::size_t p, Many many) const {
    const auto read = [&](int column) { return load_in_double(A_[static_cast<std::size_t>(column)] + p, many); };
    if constexpr (Mode::mode == AffineMode::rigid)
      return cross_sign<Dim>(d, a) > 0 ? read(cross_axis<Dim>(d, a)) : -read(cross_axis<Dim>(d, a));
    else if constexpr (Mode::mode == AffineMode::full)
      return read(a * Dim + d);
    else
      return read(a * ((1 << Dim) - 1) + (1 << d) - 1);
  }

  /// D on an axis of a lattice with this origin, m^2; the place is the one that the transfers round to.
  template <class K, class Many> [[nodiscard]] T second_moment(K, const Real* x, Many many, Real offset) const {
    const T at = in_double(load_narrow(x, many) * walk_.inverse_dx + static_cast<Real>(Grid<Dim>::pad) - offset);
    return T(dx_squared_) * K::second_moment(at - K::base(at));
  }

  KernelName kernel_;
  Walk<Dim, Real> walk_;
  double dx_squared_;
  Vec<Dim, double> origin_;
  std::array<const Real*, Dim> x_, v_;
  std::array<const Real*, columns> A_;
  const Real* mass_;
  const std::uint8_t* only_; ///< null: all
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
  if (only && (only->empty() || std::memchr(only->data(), 1, only->size()) == nullptr)) return {};
  return with_mode<Dim, Real>(particles.mode, [&](auto mode) {
    const ParticleSums<decltype(mode), Dim, Real> sums(kernel, layout, grid, origin, particles,
                                                       only ? only->data() : nullptr);
    return pool.sum(static_cast<std::int64_t>(particles.size()), particles_per_chunk, Totals<Dim>(),
                    [&](std::int64_t begin, std::int64_t end) {
                      return sums(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
                    });
  });
}

namespace {

/// sum m, m u, m u^2 and i m u along a stretch of a row of samples.
struct RowSums {
  using T = Pack<double>;
  T m = T(0), mu = T(0), muu = T(0), imu = T(0);

  template <class Real> RowSums(const Real* mass, const Real* velocity, int begin, int end) {
    constexpr auto step = static_cast<int>(lanes_of<T>);
    std::array<double, lanes_of<T>> at;
    for (std::size_t l = 0; l < at.size(); ++l) at[l] = begin + static_cast<int>(l);
    T i = T::load_unaligned(at.data());
    int k = begin;
    for (; k + step <= end; k += step, i += T(step)) add(in_double(load_narrow(mass + k, step)), velocity + k, step, i);
    if (k == end) return;
    std::array<double, lanes_of<T>> last{};
    for (std::size_t l = 0; k + static_cast<int>(l) < end; ++l)
      last[l] = static_cast<double>(mass[k + static_cast<int>(l)]);
    add(T::load_unaligned(last.data()), velocity + k, static_cast<std::size_t>(end - k), i);
  }

private:
  template <class Real> void add(const T& mass, const Real* velocity, std::size_t many, const T& i) {
    const T u = load_in_double(velocity, many), au = mass * u;
    m += mass;
    mu += au;
    muu += au * u;
    imu += i * au;
  }
};

} // namespace

template <int Dim, class Real>
void Stretches<Dim, Real>::find(const Grid<Dim>& grid, const Components<Dim, Real>& m, Pool& pool) {
  const int length = grid.extent()[0];
  const auto rows = static_cast<std::size_t>(grid.size() / length);
  for (std::size_t a = 0; a < Dim; ++a) {
    of[a].resize(rows);
    pool.ranges(static_cast<std::int64_t>(rows), 1 + samples_per_chunk / length,
                [&](std::int64_t begin, std::int64_t end) {
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
    int begin = lo[0], end = hi[0];
    if (stretches) {
      const auto& [first, last] = stretches->of[c][static_cast<std::size_t>(row / extent[0])];
      begin = std::max(begin, first), end = std::min(end, last);
      if (begin >= end) return;
    }
    const RowSums s(m[c].data() + row, u[c].data() + row, begin, end);
    const double momentum = sum_of(s.mu);
    sum.mass += sum_of(s.m) / Dim;
    sum.momentum[a] += momentum;
    sum.kinetic_energy += sum_of(s.muu) / 2;
    const Vec<Dim, double> lattice = component_origin<Dim, double>(layout, a);
    for (int d = 0; d < Dim; ++d) {
      if (d == a) continue;
      const double first = grid.dx * ((i[d] - Grid<Dim>::pad) + lattice[d]) - origin[d]; // of x_d - origin in the row
      const double moment = first * momentum + (d == 0 ? grid.dx * sum_of(s.imu) : 0.0);
      sum.angular_momentum[cross_axis<Dim>(d, a)] += cross_sign<Dim>(d, a) * moment;
    }
  };
  return pool.sum(grid.size() / extent[0], 1 + samples_per_chunk / extent[0], Totals<Dim>(),
                  [&](std::int64_t begin, std::int64_t end) {
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
