// SPDX-License-Identifier: MIT
#include "sim/fluid/pcg.h"

#include <cmath>

namespace flipbook {
namespace {

constexpr std::int64_t grain = 4096;

template <class Body> void each_row(std::size_t rows, Pool& pool, Body&& body) {
  pool.ranges(static_cast<std::int64_t>(rows), grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) body(i);
  });
}

/// Sum of x_i y_i.
template <class X> double dot(const std::vector<double>& x, const std::vector<X>& y, Pool& pool) {
  return pool.sum(static_cast<std::int64_t>(x.size()), grain, 0.0, [&](std::int64_t begin, std::int64_t end) {
    double sum = 0;
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      sum += x[i] * static_cast<double>(y[i]);
    return sum;
  });
}

} // namespace

template <int Dim, class Real> void PressureCg<Dim, Real>::factorise(const System& system, PressureSolver solver) {
  const auto& rows = system.rows;
  inverse_e_.resize(rows.size());
  upper_.resize(rows.size()); // sum of the weights towards higher rows
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const Real diagonal = static_cast<Real>(row.diagonal);
    Real e = diagonal;
    upper_[i] = 0;
    for (std::size_t s = 0; s < System::sides; ++s) {
      const auto j = static_cast<std::size_t>(row.neighbour[s]);
      const Real w = row.weight[s];
      if (j > i)
        upper_[i] += w;
      else if (solver == PressureSolver::mic)
        e -= w * inverse_e_[j] * (w + Real(0.97) * (upper_[j] - w));
    }
    if (e < Real(0.25) * diagonal) e = diagonal; // keeps the factors of a singular matrix positive
    inverse_e_[i] = e > 0 ? 1 / e : Real(0);
  }
}

template <int Dim, class Real>
void PressureCg<Dim, Real>::precondition(const System& system, PressureSolver solver, Pool& pool) {
  const auto& rows = system.rows;
  if (solver == PressureSolver::cg) {
    each_row(rows.size(), pool, [&](std::size_t i) { z_[i] = inverse_e_[i] * static_cast<Real>(r_[i]); });
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) { // (E + L) y = r
    Real sum = static_cast<Real>(r_[i]);
    for (std::size_t s = 0; s < System::sides; ++s) {
      const auto j = static_cast<std::size_t>(rows[i].neighbour[s]);
      if (j < i) sum += rows[i].weight[s] * z_[j];
    }
    z_[i] = inverse_e_[i] * sum;
  }
  for (std::size_t i = rows.size(); i-- > 0;) { // (E + L^T) z = E y
    Real sum = 0;
    for (std::size_t s = System::sides; s-- > 0;) {
      const auto j = static_cast<std::size_t>(rows[i].neighbour[s]);
      if (j > i) sum += rows[i].weight[s] * z_[j];
    }
    z_[i] += inverse_e_[i] * sum;
  }
}

template <int Dim, class Real>
SolveReport PressureCg<Dim, Real>::solve(const System& system, const PressureSettings& settings, std::vector<double>& p,
                                         Pool& pool) {
  const std::size_t n = system.rows.size();
  for (auto* x : {&r_, &s_, &q_}) x->resize(n);
  z_.resize(n);
  const double norm_b = std::sqrt(dot(system.rhs, system.rhs, pool));
  if (norm_b == 0) {
    p.assign(n, 0.0);
    return {};
  }
  const auto residual = [&] { // r = b - A p
    system.multiply(p, q_, pool);
    each_row(n, pool, [&](std::size_t i) { r_[i] = system.rhs[i] - q_[i]; });
    return std::sqrt(dot(r_, r_, pool)) / norm_b;
  };
  system.remove_pocket_means(p);
  SolveReport report{0, residual()};
  if (report.residual > 1) { // a guess worse than none
    p.assign(n, 0.0);
    r_ = system.rhs;
    report.residual = 1;
  }
  if (report.residual <= settings.tolerance) return report;

  factorise(system, settings.solver);
  precondition(system, settings.solver, pool);
  s_.assign(z_.begin(), z_.end());
  double sigma = dot(r_, z_, pool);
  while (report.residual > settings.tolerance && report.iterations < settings.max_iterations) {
    ++report.iterations;
    system.multiply(s_, q_, pool);
    const double curvature = dot(s_, q_, pool);
    if (!(curvature > 0)) break; // rounding has used up the search directions
    const double alpha = sigma / curvature;
    each_row(n, pool, [&](std::size_t i) {
      p[i] += alpha * s_[i];
      r_[i] -= alpha * q_[i];
    });
    report.residual = std::sqrt(dot(r_, r_, pool)) / norm_b;
    precondition(system, settings.solver, pool);
    const double next = dot(r_, z_, pool);
    const double beta = next / sigma;
    each_row(n, pool, [&](std::size_t i) { s_[i] = static_cast<double>(z_[i]) + beta * s_[i]; });
    sigma = next;
  }
  system.remove_pocket_means(p);
  report.residual = residual(); // not the recursion's, which may promise more than rounding allows
  return report;
}

#define FLIPBOOK_PCG(Real)                                                                                             \
  template class PressureCg<2, Real>;                                                                                  \
  template class PressureCg<3, Real>;
FLIPBOOK_PCG(float)
FLIPBOOK_PCG(double)
#undef FLIPBOOK_PCG

} // namespace flipbook
