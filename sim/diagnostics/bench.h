// SPDX-License-Identifier: MIT
// A trial with the transfers that the solver runs, and the totals of the tech report of APIC before and after them.
#pragma once

#include "sim/core/cross.h"
#include "sim/diagnostics/ledger.h"
#include "sim/diagnostics/trial.h"
#include "sim/transfer/transfer.h"
#include "sim/transfer/xpic.h"

#include <cmath>

namespace flipbook {

/// worst <- the larger of the two; a NaN is the worst of all and stays.
inline void keep_worst(double& worst, double x) {
  if (std::isnan(x) || x > worst) worst = x;
}

/// What sums of momenta are measured against: what they would be if nothing in them cancelled.
struct Scale {
  double momentum = 0; ///< sum m |v|
  double angular = 0;  ///< sum m |x| |v|, x from the origin
};

template <int Dim, class Real> struct Bench {
  Corner corner;
  KernelName kernel;
  Layout layout;
  Pool& pool;
  Trial<Dim, Real> trial;
  Components<Dim, Real> m, u; ///< on the grid, after scatter()

  static constexpr int particles = 40;

  Bench(const Corner& c, KernelName k, Layout l, std::uint64_t seed, Pool& p, int room = 0)
      : corner(c), kernel(k), layout(l), pool(p), trial(c.mode, particles, seed, p, room) {
    m.resize(trial.grid);
    u.resize(trial.grid);
  }

  void scatter() {
    p2g(corner, kernel, layout, trial.grid, trial.particles, trial.order, m, u, pool);
    to_velocity(m, u, pool);
  }
  void gather(const Components<Dim, Real>& next) {
    XpicTerms<Dim, Real> xpic;
    const auto fold = [](Components<Dim, Real>&) {}; // no side is periodic
    xpic.gather(corner, kernel, layout, trial.grid, next, u, trial.order, fold, trial.particles, pool);
  }

  /// Definitions 3.5 and 4.1 or 5.1: L_P = sum x_p x m v_p, plus what omega_p or C_p holds.
  [[nodiscard]] Totals<Dim> on_particles() const {
    return particle_totals(kernel, layout, trial.grid, trial.particles, trial.origin, pool);
  }
  /// Definitions 3.1 and 3.2: L_G = sum x_i x m_i v_i.
  [[nodiscard]] Totals<Dim> on_grid(const Components<Dim, Real>& field) const {
    return grid_totals(layout, trial.grid, m, field, trial.origin, pool);
  }
  /// Definition 3.4: L_G = sum x~_i x m_i v~_i with the moved samples x~_i = x_i + dt v~_i. A face moves along its own
  /// axis, for it has one component only.
  [[nodiscard]] Vec<spin<Dim>, double> moved_angular_momentum(const Components<Dim, Real>& v, double dt) const {
    Vec<spin<Dim>, double> L = Vec<spin<Dim>, double>::Zero();
    for (int a = 0; a < Dim; ++a)
      trial.each_sample(layout, a, [&](std::size_t k, const Vec<Dim, double>& x) {
        Vec<Dim, double> moved = x - trial.origin, momentum = Vec<Dim, double>::Zero();
        for (int b = 0; b < Dim; ++b)
          if (layout == Layout::nodes || b == a)
            moved[b] += dt * static_cast<double>(v[static_cast<std::size_t>(b)][k]);
        const auto c = static_cast<std::size_t>(a);
        momentum[a] = static_cast<double>(m[c][k]) * static_cast<double>(v[c][k]);
        L += cross<Dim, double>(moved, momentum);
      });
    return L;
  }

  [[nodiscard]] Scale scale() const {
    Scale s;
    for (std::size_t p = 0; p < trial.particles.size(); ++p) {
      const double mv =
          static_cast<double>(trial.particles.m[p]) * static_cast<double>(trial.particles.velocity(p).norm());
      s.momentum += mv;
      s.angular += mv * (trial.particles.position(p).template cast<double>() - trial.origin).norm();
    }
    return s;
  }

  /// The largest difference between two fields on samples with mass, relative to the largest value of the first.
  [[nodiscard]] double field_error(const Components<Dim, Real>& before, const Components<Dim, Real>& after) const {
    double worst = 0, largest = 0;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t k = 0; k < before[a].size(); ++k) {
        if (!(m[a][k] > 0)) continue;
        keep_worst(worst, std::abs(static_cast<double>(after[a][k]) - static_cast<double>(before[a][k])));
        keep_worst(largest, std::abs(static_cast<double>(before[a][k])));
      }
    return worst / largest;
  }
};

} // namespace flipbook
