// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/transfer/transfer.h"
#include "sim/transfer/xpic.h"

namespace flipbook {
namespace {

/// Random particles, what P2G makes of them, and the update of XPIC on an idle grid.
template <int Dim> struct Filter {
  using Field = Components<Dim, double>;
  Threads threads{1};
  Trial<Dim, double> trial{AffineMode::none, 200, 11, threads.pool};
  KernelName kernel;
  Layout layout;
  Field m, u_old;

  Filter(KernelName k, Layout l) : kernel(k), layout(l) {
    m.resize(trial.grid);
    u_old.resize(trial.grid);
    scatter(trial.particles, u_old);
  }
  void scatter(const Particles<Dim, double>& particles, Field& u) {
    p2g({}, kernel, layout, trial.grid, particles, trial.order, m, u, threads.pool);
    to_velocity(m, u, threads.pool);
  }
  /// The particles after XPIC(terms) on a grid that did nothing.
  Particles<Dim, double> filtered(int terms) {
    XpicTerms<Dim, double> xpic;
    const Field& more = xpic(
        terms, kernel, layout, trial.grid, trial.particles, trial.order, u_old, [](Field&) {}, threads.pool);
    Field u = u_old;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t i = 0; i < u[a].size(); ++i) u[a][i] += more[a][i];
    Particles<Dim, double> after = trial.particles;
    g2p({}, kernel, layout, trial.grid, u, u, after, threads.pool);
    return after;
  }
  /// What the grid sees of the difference from the velocities before.
  double seen(const Particles<Dim, double>& after) {
    Field u;
    u.resize(trial.grid);
    scatter(after, u);
    double sum = 0;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t i = 0; i < u[a].size(); ++i) sum += m[a][i] * (u[a][i] - u_old[a][i]) * (u[a][i] - u_old[a][i]);
    return std::sqrt(sum);
  }
};

template <class Body> void each_filter(Body&& body) {
  for (const KernelName k : kernels)
    for (const Layout l : layouts) {
      SCOPED_TRACE(std::string(kernel_options()[static_cast<std::size_t>(k)].name) +
                   (l == Layout::mac ? ", mac" : ", nodes"));
      body(Filter<2>(k, l));
      body(Filter<3>(k, l));
    }
}

TEST(Xpic, OfOrderOneIsPic) {
  each_filter([](auto&& f) {
    auto pic_particles = f.trial.particles;
    g2p({}, f.kernel, f.layout, f.trial.grid, f.u_old, f.u_old, pic_particles, f.threads.pool);
    EXPECT_EQ(f.filtered(1).v, pic_particles.v);
    EXPECT_NE(f.filtered(2).v, pic_particles.v);
  });
}

TEST(Xpic, EachTermBringsTheGridCloserToWhatItWas) {
  each_filter([](auto&& f) {
    double before = f.seen(f.filtered(1));
    const double first = before;
    EXPECT_GT(first, 0.05);
    for (const int terms : {2, 4, 8, 16}) {
      const double now = f.seen(f.filtered(terms));
      EXPECT_LT(now, before) << terms << " terms";
      before = now;
    }
    EXPECT_LT(before, first / 3);
  });
}

/// The form that its authors give for particles: v_p <- (I - (I - S S+)^m) V on an idle grid.
TEST(Xpic, IsTheFilterOfThePublishedFormOnParticles) {
  each_filter([](auto&& f) {
    auto rest = f.trial.particles; // (I - S S+)^m V
    auto gathered = rest;
    auto u = f.u_old;
    for (int l = 0; l < 4; ++l) {
      f.scatter(rest, u);
      g2p({}, f.kernel, f.layout, f.trial.grid, u, u, gathered, f.threads.pool);
      for (std::size_t a = 0; a < rest.v.size(); ++a)
        for (std::size_t p = 0; p < rest.size(); ++p) rest.v[a][p] -= gathered.v[a][p];
    }
    const auto after = f.filtered(4);
    for (std::size_t p = 0; p < after.size(); ++p)
      EXPECT_LT((after.velocity(p) - (f.trial.particles.velocity(p) - rest.velocity(p))).norm(), 1e-12);
  });
}

TEST(Xpic, ConservesMomentum) {
  each_filter([](auto&& f) {
    const auto momentum = [](const auto& particles) {
      auto sum = (particles.m[0] * particles.velocity(0)).eval();
      for (std::size_t p = 1; p < particles.size(); ++p) sum += particles.m[p] * particles.velocity(p);
      return sum;
    };
    EXPECT_LT((momentum(f.filtered(5)) - momentum(f.trial.particles)).norm(), 1e-11);
  });
}

} // namespace
} // namespace flipbook
