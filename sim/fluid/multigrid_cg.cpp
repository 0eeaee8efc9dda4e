// SPDX-License-Identifier: MIT
#include "sim/fluid/multigrid_cg.h"

#include <cmath>
#include <limits>

namespace flipbook {
namespace {

/// sum of f g over the cells.
template <int Dim, class F, class G>
double dot(const PressureLevel<Dim>& level, const Coloured<F>& f, const Coloured<G>& g, Pool& pool) {
  return level.sum(pool, [&](const Piece& piece, Lanes& lanes) {
    for (const int colour : {0, 1}) {
      const F* x = f.of(colour) + piece.at;
      const G* y = g.of(colour) + piece.at;
      lanes.add(piece.count(), [&](int i) { return static_cast<double>(x[i]) * static_cast<double>(y[i]); });
    }
  });
}

/// s.A s = sum over faces of w (s_i - s_j)^2 + sum of e s^2: without differences of large numbers.
template <int Dim> double energy(const PressureLevel<Dim>& level, const Coloured<float>& s, Pool& pool) {
  const Around<Dim, float> around[] = {{level.board, s, 0}, {level.board, s, 1}};
  const Arms<Dim, float> arms[] = {{level.board, level.A, 0}, {level.board, level.A, 1}};
  return level.sum(pool, [&](const Piece& piece, Lanes& lanes) {
    for (const int colour : {0, 1}) {
      const auto low = around[colour].low(piece);
      const float* own = s.of(colour) + piece.at;
      const auto square = [&](auto a, int i) { return (own[i] - low[a][i]) * (own[i] - low[a][i]); };
      if (piece.plain) {
        lanes.add(piece.count(), [&](int i) { return over_axes<Dim>([&](auto a) { return square(a, i); }); });
        continue;
      }
      const auto w = arms[colour].low(piece);
      const float *e = level.A.e.of(colour) + piece.at, *inverse = level.inverse_d.of(colour) + piece.at;
      lanes.add(piece.count(), [&](int i) {
        const float sum = e[i] * own[i] * own[i] + over_axes<Dim>([&](auto a) { return w[a][i] * square(a, i); });
        return inverse[i] > 0 ? sum : 0.0f; // pads hold weights as well
      });
    }
  });
}

} // namespace

/// r = b - A p, over |b| so that single precision can hold it, into b of the finest level; its norm.
template <int Dim, class Real>
double MultigridCg<Dim, Real>::find_residual(Lattice& lattice, const Coloured<double>& p, Pool& pool) {
  PressureLevel<Dim>& level = lattice.level();
  const double inverse_b = 1 / norm_b_;
  const Apply<Dim, Real, double> A[] = {{level.board, lattice.matrix(), level.full, p, 0},
                                        {level.board, lattice.matrix(), level.full, p, 1}};
  const double square = level.sum(pool, [&](const Piece& piece, Lanes& lanes) {
    for (const int colour : {0, 1}) {
      const double* b = lattice.b.of(colour) + piece.at;
      const float* inverse = level.inverse_d.of(colour) + piece.at;
      float* r = level.b.of(colour) + piece.at;
      A[colour](piece, [&](int i, double Ap) { r[i] = static_cast<float>((b[i] - Ap) * inverse_b); });
      if (!piece.plain)
        for (int i = 0, n = piece.count(); i < n; ++i) r[i] = inverse[i] > 0 ? r[i] : 0.0f; // pads hold weights as well
      lanes.add(piece.count(), [&](int i) { return static_cast<double>(r[i]) * static_cast<double>(r[i]); });
    }
  });
  return std::sqrt(square);
}

/// One iteration but for the residual; false where rounding has used up the directions.
template <int Dim, class Real> bool MultigridCg<Dim, Real>::step(Lattice& lattice, Coloured<double>& p, Pool& pool) {
  PressureLevel<Dim>& level = lattice.level();
  lattice.multigrid().cycle(pool);
  const double next = dot(level, level.b, level.x, pool);
  const float beta = sigma_ > 0 ? static_cast<float>(next / sigma_) : 0;
  sigma_ = next;
  level.each_piece(pool, [&](const Piece& piece) {
    for (const int colour : {0, 1}) {
      const float* z = level.x.of(colour) + piece.at;
      float* s = s_.of(colour) + piece.at;
      FLIPBOOK_INDEPENDENT
      for (int i = 0, n = piece.count(); i < n; ++i) s[i] = z[i] + beta * s[i];
    }
  });
  level.board.fill_pads(s_, pool);
  const double curvature = energy(level, s_, pool);
  if (!(sigma_ > 0 && curvature > 0)) return false;
  const double alpha = sigma_ / curvature * norm_b_;
  level.each_piece(pool, [&](const Piece& piece) {
    for (const int colour : {0, 1}) {
      const float* s = s_.of(colour) + piece.at;
      double* to = p.of(colour) + piece.at;
      FLIPBOOK_INDEPENDENT
      for (int i = 0, n = piece.count(); i < n; ++i) to[i] += alpha * static_cast<double>(s[i]);
    }
  });
  level.board.fill_pads(p, pool);
  return true;
}

/// The residual that rounding leaves, however good p is: eps |d p| / |b|, times a few operations.
template <int Dim, class Real>
double MultigridCg<Dim, Real>::rounding(Lattice& lattice, const Coloured<double>& p, Pool& pool) const {
  const PressureLevel<Dim>& level = lattice.level();
  const double square = level.sum(pool, [&](const Piece& piece, Lanes& lanes) {
    for (const int colour : {0, 1}) {
      const double* x = p.of(colour) + piece.at;
      const float* inverse = level.inverse_d.of(colour) + piece.at;
      lanes.add(piece.count(), [&](int i) {
        const double dp = inverse[i] > 0 ? x[i] / static_cast<double>(inverse[i]) : 0;
        return dp * dp;
      });
    }
  });
  return 10 * std::numeric_limits<double>::epsilon() * std::sqrt(square) / norm_b_;
}

template <int Dim, class Real>
SolveReport MultigridCg<Dim, Real>::solve(Lattice& lattice, const PressureSettings& settings, const Progress& progress,
                                          Coloured<double>& p, Pool& pool, Profile* profile) {
  PressureLevel<Dim>& level = lattice.level();
  norm_b_ = std::sqrt(dot(level, lattice.b, lattice.b, pool));
  if (norm_b_ == 0) {
    p.clear(pool);
    return {};
  }
  lattice.pockets().remove_means(p, pool);
  level.board.fill_pads(p, pool);
  SolveReport report{0, find_residual(lattice, p, pool)};
  if (report.residual > 1) { // a guess worse than none
    p.clear(pool);
    report.residual = find_residual(lattice, p, pool);
  }
  if (report.residual <= settings.tolerance) return report;

  {
    const Timed timed(profile, Phase::pressure_setup);
    lattice.multigrid().coarsen(pool);
  }
  s_.resize(level.board.half);
  s_.clear(pool);
  sigma_ = 0;
  double least = report.residual, before = report.residual; // and that of the last look
  while (report.residual > settings.tolerance && report.iterations < settings.max_iterations) {
    ++report.iterations;
    report.stalled = !step(lattice, p, pool);
    report.residual = find_residual(lattice, p, pool);
    least = std::min(least, report.residual);
    if (report.iterations % progress.iterations == 0) {
      report.stalled = report.stalled || !(least < progress.factor * std::exchange(before, least));
    }
    if (report.stalled) break;
  }
  report.stalled = report.stalled && report.residual > std::max(settings.tolerance, rounding(lattice, p, pool));
  lattice.pockets().remove_means(p, pool);
  return report;
}

#define FLIPBOOK_MULTIGRID_CG(Real)                                                                                    \
  template class MultigridCg<2, Real>;                                                                                 \
  template class MultigridCg<3, Real>;
FLIPBOOK_MULTIGRID_CG(float)
FLIPBOOK_MULTIGRID_CG(double)
#undef FLIPBOOK_MULTIGRID_CG

} // namespace flipbook
