// SPDX-License-Identifier: MIT
// P2G and G2P alone, for every paint mode, kernel, dimension, precision and lattice: nanoseconds a particle, and how
// that compares with linear APIC when each is divided by the samples that its stencil has.
#include "app/bench/workload.h"
#include "sim/core/profile.h"
#include "sim/core/random.h"
#include "sim/transfer/transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace flipbook::app {

namespace {

struct Mode {
  const char* name;
  AffineMode mode;
};
constexpr std::array modes{Mode{"full", AffineMode::full}, Mode{"none", AffineMode::none},
                           Mode{"rigid", AffineMode::rigid}, Mode{"polynomial", AffineMode::polynomial}};

/// Seconds of the wall and of the processors.
template <class Body> Profile::Spent time_of(Body&& body) {
  Profile p;
  {
    const Timed timed(&p, Phase::other);
    body();
  }
  return p.spent[static_cast<std::size_t>(Phase::other)];
}

/// What the formula needs for a particle and a sample of one component: the product of the weights, the value that is
/// painted or the coefficients that are gathered, and the sums.
double flops(int dim, AffineMode mode, bool p2g) {
  const double weight = dim - 1;
  double slopes = 0; // numbers of the affine state that a component has
  switch (mode) {
  case AffineMode::none: break;
  case AffineMode::rigid: slopes = dim - 1; break;
  case AffineMode::full: slopes = dim; break;
  case AffineMode::polynomial: slopes = (1 << dim) - 1; break;
  }
  return weight + 2 * slopes + (p2g ? 3 : 2);
}

/// A cube full of 2^Dim particles a cell, moving somehow.
template <int Dim, class Real> Particles<Dim, Real> random_particles(const Grid<Dim>& grid) {
  Particles<Dim, Real> particles;
  const int n = 2 * grid.cells[0];
  const auto count = static_cast<std::uint32_t>(std::lround(std::pow(n, Dim)));
  for (std::uint32_t p = 0; p < count; ++p) {
    Vec<Dim, Real> x, v;
    std::uint32_t rest = p;
    for (int d = 0; d < Dim; ++d, rest /= static_cast<std::uint32_t>(n)) {
      const auto axis = static_cast<std::uint32_t>(d);
      const double place = rest % static_cast<std::uint32_t>(n) + uniform(1, p, axis);
      x[d] = static_cast<Real>(std::min(place, n - 1e-3) * grid.dx / 2);
      v[d] = static_cast<Real>(2 * uniform(2, p, axis) - 1);
    }
    particles.add(x, v, Real(1), p);
  }
  return particles;
}

template <int Dim, class Real> class Bench {
public:
  Bench(const Workload& w, const BenchRequest& request, const TakeCase& take, Pool& pool)
      : workload_(w), request_(request), take_(take), pool_(pool) {
    grid_.cells = Index<Dim>::Constant(request.small ? 6 : Dim == 2 ? 256 : 32);
    grid_.dx = 1.0 / grid_.cells[0];
    particles_ = random_particles<Dim, Real>(grid_);
    sort_by_cell(particles_, grid_, order_, pool_);
    for (Components<Dim, Real>* field : {&m_, &u_, &u_old_}) field->resize(grid_);
  }

  void run() {
    for (const Layout layout : {Layout::mac, Layout::nodes})
      for (std::size_t kernel = 0; kernel < kernel_options().size(); ++kernel)
        for (const Mode& mode : modes) measure(layout, static_cast<KernelName>(kernel), mode);
  }

private:
  void measure(Layout layout, KernelName kernel, const Mode& mode) {
    const std::string kernel_name(kernel_options()[static_cast<std::size_t>(kernel)].name);
    const int support = with_kernel(kernel, [](auto k) { return decltype(k)::support; });
    const double stencil = std::pow(support, Dim), count = static_cast<double>(particles_.size());
    CaseResult result{workload_.name,
                      std::to_string(Dim) + "D " + (sizeof(Real) == sizeof(float) ? "single " : "double ") +
                          (layout == Layout::mac ? "mac " : "nodes ") + kernel_name + " " + mode.name,
                      grouped_number(count) + " particles",
                      {}};
    const Corner corner{.mode = mode.mode};
    particles_.set_mode(mode.mode);
    for (int repeat = 0; repeat < request_.repetitions(); ++repeat) {
      const Profile::Spent to_grid =
          time_of([&] { p2g(corner, kernel, layout, grid_, particles_, order_, m_, u_, pool_); });
      to_velocity(m_, u_, pool_);
      const Profile::Spent to_particles =
          time_of([&] { g2p(corner, kernel, layout, grid_, u_, u_old_, particles_, pool_); });
      if (repeat == 0) continue;
      add(result, "P2G", to_grid, {layout, true}, stencil, flops(Dim, mode.mode, true));
      add(result, "G2P", to_particles, {layout, false}, stencil, flops(Dim, mode.mode, false));
    }
    take_(result);
  }

  /// The first case of each lattice is linear APIC: what the others are measured by.
  void add(CaseResult& result, const std::string& part, const Profile::Spent& spent, std::pair<Layout, bool> which,
           double stencil, double flops_of_sample) {
    const double count = static_cast<double>(particles_.size()), ns = 1e9 * spent.wall / count,
                 cpu_ns = 1e9 * spent.cpu / count;
    result.add(part, "wall per particle", "ns", ns);
    result.add(part, "cpu per particle", "ns", cpu_ns);
    result.add(part, "particles", "M/s", 1e3 / ns);
    std::vector<double>& own = linear_apic_[which];
    const auto at = result.find(part, "wall per particle")->values.size() - 1;
    if (own.size() <= at) own.push_back(ns / stencil);
    result.add(part, "per sample, linear APIC = 1", "1", ns / stencil / own[at]);
    if (request_.limits.flops > 0)
      result.add(part, "of flops", "%", 100 * flops_of_sample * Dim * stencil / (1e-9 * ns) / request_.limits.flops);
  }

  const Workload& workload_;
  const BenchRequest& request_;
  const TakeCase& take_;
  Pool& pool_;
  Grid<Dim> grid_;
  Particles<Dim, Real> particles_;
  CellOrder<Dim> order_;
  Components<Dim, Real> m_, u_, u_old_;
  std::map<std::pair<Layout, bool>, std::vector<double>> linear_apic_; ///< ns a particle and sample, by repeat
};

} // namespace

void run_transfers(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  Budget budget(request.threads);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  Bench<3, float>(w, request, take, pool).run();
  Bench<3, double>(w, request, take, pool).run();
  Bench<2, float>(w, request, take, pool).run();
  Bench<2, double>(w, request, take, pool).run();
}

} // namespace flipbook::app
