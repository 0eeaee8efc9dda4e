// SPDX-License-Identifier: MIT
#include "sim/transfer_only/kept.h"

#include <Eigen/LU>

#include <cmath>

namespace flipbook {
namespace {

constexpr std::int64_t grain = 4096;
/// Of an affine part: below this share of the whole it is what rounding, or the jitter of a vortex, leaves.
constexpr double negligible = 1e-3;

/// Sums that an affine fit needs, about the particles' centre.
template <int Dim> struct Sums {
  Mat<Dim, double> xx = Mat<Dim, double>::Zero();                                      ///< sum m x x^T
  Mat<Dim, double> vx = Mat<Dim, double>::Zero(), vx_start = Mat<Dim, double>::Zero(); ///< sum m v x^T
  double v_start2 = 0, v_dot = 0, difference2 = 0; ///< <v_0, v_0>, <v, v_0>, |v - v_0|^2

  Sums& operator+=(const Sums& o) {
    xx += o.xx, vx += o.vx, vx_start += o.vx_start;
    v_start2 += o.v_start2, v_dot += o.v_dot, difference2 += o.difference2;
    return *this;
  }
};

template <int Dim> struct Mean {
  double m = 0;
  Vec<Dim, double> x = Vec<Dim, double>::Zero();
  Mean& operator+=(const Mean& o) {
    m += o.m, x += o.x;
    return *this;
  }
};

/// sum of add(particle, sum) over all particles.
template <class Sum, class Add> Sum sum_over(std::size_t count, Pool& pool, Add&& add) {
  return pool.sum(static_cast<std::int64_t>(count), grain, Sum(), [&](std::int64_t begin, std::int64_t end) {
    Sum sum;
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) add(p, sum);
    return sum;
  });
}

/// a : b / b : b of what is left of both, unless b is a negligible part of `whole`.
template <int Dim>
std::optional<double> share(const Mat<Dim, double>& a, const Mat<Dim, double>& b, const Mat<Dim, double>& whole) {
  if (!(b.norm() > negligible * whole.norm())) return std::nullopt;
  return (a.array() * b.array()).sum() / b.squaredNorm();
}

} // namespace

template <int Dim, class Real> Kept kept(const TripState<Dim, Real>& s, Pool& pool) {
  const auto& p = s.particles;
  const auto mean = sum_over<Mean<Dim>>(p.size(), pool, [&](std::size_t q, Mean<Dim>& sum) {
    const auto m = static_cast<double>(p.m[q]);
    sum.m += m;
    sum.x += m * p.position(q).template cast<double>();
  });
  const Vec<Dim, double> centre = mean.x / mean.m;
  const auto sums = sum_over<Sums<Dim>>(p.size(), pool, [&](std::size_t q, Sums<Dim>& sum) {
    const auto m = static_cast<double>(p.m[q]);
    const Vec<Dim, double> x = p.position(q).template cast<double>() - centre,
                           v = p.velocity(q).template cast<double>();
    Vec<Dim, double> start;
    for (int d = 0; d < Dim; ++d) start[d] = static_cast<double>(s.v_start[static_cast<std::size_t>(d)][q]);
    sum.xx += m * x * x.transpose();
    sum.vx += m * v * x.transpose();
    sum.vx_start += m * start * x.transpose();
    sum.v_start2 += m * start.squaredNorm();
    sum.v_dot += m * v.dot(start);
    sum.difference2 += m * (v - start).squaredNorm();
  });
  Kept k;
  if (!(sums.v_start2 > 0)) return k;
  k.residual = std::sqrt(sums.difference2 / sums.v_start2);
  k.kept = sums.v_dot / sums.v_start2;
  // A row of particles, or one alone, has no gradient.
  if (s.any_periodic() || !(std::abs(sums.xx.determinant()) > std::pow(1e-6 * sums.xx.trace(), Dim))) return k;
  const Mat<Dim, double> inverse = sums.xx.inverse(), A = sums.vx * inverse, A_start = sums.vx_start * inverse;
  // What the gradient amounts to over the body, against the speed of the start.
  if (!(A_start.squaredNorm() * sums.xx.trace() > negligible * negligible * sums.v_start2)) return k;
  k.rotation = share<Dim>((A - A.transpose()) / 2, (A_start - A_start.transpose()) / 2, A_start);
  k.strain = share<Dim>((A + A.transpose()) / 2, (A_start + A_start.transpose()) / 2, A_start);
  return k;
}

template Kept kept(const TripState<2, float>&, Pool&);
template Kept kept(const TripState<2, double>&, Pool&);
template Kept kept(const TripState<3, float>&, Pool&);
template Kept kept(const TripState<3, double>&, Pool&);

} // namespace flipbook
