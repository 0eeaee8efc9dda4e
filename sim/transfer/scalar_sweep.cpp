// SPDX-License-Identifier: MIT
#include "sim/transfer/scalar_sweep.h"

#include "sim/transfer/stencil.h"
#include "sim/transfer/tile.h"

#include <stdexcept>

namespace flipbook {
namespace {

constexpr std::int64_t particles_per_chunk = 1 << 10;

/// The samples around one particle as the scheme sees them, with their places in the fields.
template <class K, int Dim, class Real> class Around {
public:
  static constexpr std::size_t count = power(K::support, Dim);

  explicit Around(const Walk<Dim, Real>& walk) : walk_(walk) {}

  void move_to(const Particles<Dim, Real>& particles, std::size_t p) {
    const Stencil<K, Dim, Real, AffineWeights> stencil(
        walk_, walk_.position([&](std::size_t d) { return particles.x[d][p]; }));
    for (int a = 0; a < Dim; ++a)
      for (std::size_t n = 0; n < count; ++n) place(stencil, a, n);
  }
  void read(const Components<Dim, Real>& u, const Components<Dim, Real>* u_old) {
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t n = 0; n < count; ++n) {
        samples_[a][n].u = static_cast<double>(u[a][at_[a][n]]);
        samples_[a][n].u_old = u_old ? static_cast<double>((*u_old)[a][at_[a][n]]) : 0;
      }
  }
  [[nodiscard]] ScalarSamples<Dim> samples() const {
    ScalarSamples<Dim> all;
    for (std::size_t a = 0; a < Dim; ++a) all.of[a] = samples_[a];
    return all;
  }
  [[nodiscard]] std::size_t at(std::size_t a, std::size_t n) const { return at_[a][n]; }

private:
  void place(const auto& stencil, int a, std::size_t n) {
    ScalarSample<Dim> s{1, {}, Vec<Dim, double>::Constant(static_cast<double>(walk_.inverse_dx)), 0, 0};
    std::ptrdiff_t at = stencil.first(walk_, a);
    std::size_t rest = n;
    for (int d = 0; d < Dim; rest /= K::support, ++d) {
      const auto& axis = stencil.axis(a, d);
      const std::size_t i = rest % K::support;
      const auto w = static_cast<double>(axis.w[i]), g = static_cast<double>(axis.g[i]);
      s.w *= w;
      s.r[d] = static_cast<double>((static_cast<Real>(i) - axis.f) * walk_.dx);
      for (int e = 0; e < Dim; ++e) s.fit[e] *= e == d ? g : w;
      at += static_cast<std::ptrdiff_t>(i) * walk_.stride[static_cast<std::size_t>(d)];
    }
    samples_[static_cast<std::size_t>(a)][n] = s;
    at_[static_cast<std::size_t>(a)][n] = static_cast<std::size_t>(at);
  }

  Walk<Dim, Real> walk_;
  std::array<std::array<ScalarSample<Dim>, count>, Dim> samples_{};
  std::array<std::array<std::size_t, count>, Dim> at_{};
};

template <int Dim, class Real> ScalarParticle<Dim> load(const Particles<Dim, Real>& particles, std::size_t p) {
  ScalarParticle<Dim> q;
  q.m = static_cast<double>(particles.m[p]);
  q.x = particles.position(p).template cast<double>();
  q.v = particles.velocity(p).template cast<double>();
  for (std::size_t c = 0; c < particles.A.size(); ++c) q.memory[c] = static_cast<double>(particles.A[c][p]);
  return q;
}

template <int Dim, class Real> void check_memory(const Corner& corner, const Particles<Dim, Real>& particles) {
  if (particles.mode != corner.mode) throw std::logic_error("the particles do not remember what this scheme needs");
}

/// One particle after the scheme has gathered from the samples.
template <int Dim, class Real>
void gather_one(Take take, const ScalarPart& code, const ScalarSamples<Dim>& samples, Particles<Dim, Real>& particles,
                std::size_t p) {
  ScalarParticle<Dim> q = load(particles, p);
  Vec<Dim, double> v = q.v;
  if (take == Take::increment) {
    for (int a = 0; a < Dim; ++a)
      for (const auto& s : samples[a]) v[a] += s.w * s.u;
    q.v.setZero();
    q.memory.fill(0);
  }
  code.gather(q, samples);
  if (take == Take::all) v = q.v;
  if (take != Take::memory) particles.set_velocity(p, v.template cast<Real>());
  for (std::size_t c = 0; c < particles.A.size(); ++c) {
    Real& stored = particles.A[c][p];
    stored = static_cast<Real>(q.memory[c] + (take == Take::increment ? static_cast<double>(stored) : 0.0));
  }
}

} // namespace

template <int Dim, class Real>
void scalar_p2g(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                const Particles<Dim, Real>& particles, const CellOrder<Dim>& order, Components<Dim, Real>& m,
                Components<Dim, Real>& mu, Pool& pool, const std::vector<std::uint8_t>* ballistic) {
  check_memory(corner, particles);
  const Walk<Dim, Real> walk(grid, layout);
  with_kernel(kernel, [&](auto k) {
    const auto scatter = [&](std::size_t begin, std::size_t end) {
      Around<decltype(k), Dim, Real> around(walk);
      for (std::size_t p = begin; p < end; ++p) {
        if (ballistic && (*ballistic)[p]) continue;
        const ScalarParticle<Dim> q = load(particles, p);
        around.move_to(particles, p);
        const ScalarSamples<Dim> samples = around.samples();
        for (std::size_t a = 0; a < Dim; ++a)
          for (std::size_t n = 0; n < around.count; ++n) {
            const auto& s = samples.of[a][n];
            const double wm = s.w * q.m;
            m[a][around.at(a, n)] += static_cast<Real>(wm);
            mu[a][around.at(a, n)] += static_cast<Real>(wm * corner.scalar->paint(q, static_cast<int>(a), s.r));
          }
      }
    };
    each_block(grid, pool, [&](const Index<Dim>& first) {
      const auto [begin, end] = order.block(first);
      scatter(begin, end);
    });
  });
}

template <int Dim, class Real>
void scalar_g2p(Take take, const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                const Components<Dim, Real>& u, const Components<Dim, Real>& u_old, Particles<Dim, Real>& particles,
                Pool& pool, const std::vector<std::uint8_t>* ballistic) {
  check_memory(corner, particles);
  const Walk<Dim, Real> walk(grid, layout);
  with_kernel(kernel, [&](auto k) {
    pool.ranges(static_cast<std::int64_t>(particles.size()), particles_per_chunk,
                [&](std::int64_t begin, std::int64_t end) {
                  Around<decltype(k), Dim, Real> around(walk);
                  for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
                    if (ballistic && (*ballistic)[p]) continue;
                    around.move_to(particles, p);
                    around.read(u, take == Take::increment ? nullptr : &u_old);
                    gather_one(take, *corner.scalar, around.samples(), particles, p);
                  }
                });
  });
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template void scalar_p2g(const Corner&, KernelName, Layout, const Grid<Dim>&, const Particles<Dim, Real>&,           \
                           const CellOrder<Dim>&, Components<Dim, Real>&, Components<Dim, Real>&, Pool&,               \
                           const std::vector<std::uint8_t>*);                                                          \
  template void scalar_g2p(Take, const Corner&, KernelName, Layout, const Grid<Dim>&, const Components<Dim, Real>&,    \
                           const Components<Dim, Real>&, Particles<Dim, Real>&, Pool&,                                 \
                           const std::vector<std::uint8_t>*)
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
