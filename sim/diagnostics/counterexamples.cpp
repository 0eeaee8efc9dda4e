// SPDX-License-Identifier: MIT
// COUNTEREXAMPLES: see the header. Plain on purpose: it is to be read, not to be fast.
#include "sim/diagnostics/counterexamples.h"

#include "sim/core/cross.h"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace flipbook {
namespace {

/// N(t), t in cells.
double weight(KernelName kernel, double t) {
  const double s = std::abs(t);
  switch (kernel) {
  case KernelName::linear: return s < 1 ? 1 - s : 0;
  case KernelName::quadratic: return s < 0.5 ? 0.75 - s * s : s < 1.5 ? (1.5 - s) * (1.5 - s) / 2 : 0;
  case KernelName::cubic: break;
  }
  return s < 1 ? s * s * s / 2 - s * s + 2.0 / 3 : s < 2 ? (2 - s) * (2 - s) * (2 - s) / 6 : 0;
}

/// dN/dt.
double slope(KernelName kernel, double t) {
  const double s = std::abs(t), sign = t < 0 ? -1 : 1;
  switch (kernel) {
  case KernelName::linear: return s < 1 ? -sign : 0;
  case KernelName::quadratic: return s < 0.5 ? -2 * t : s < 1.5 ? -sign * (1.5 - s) : 0;
  case KernelName::cubic: break;
  }
  return s < 1 ? sign * (1.5 * s * s - 2 * s) : s < 2 ? -sign * (2 - s) * (2 - s) / 2 : 0;
}

/// A sample on one axis: its place, x_i - x_p, N, and dN/dx_p.
struct AxisSample {
  std::ptrdiff_t index;
  double r, N, slope;
};

/// r x e_a: what a unit of velocity on a sample of component a adds to r x v.
template <int Dim> Vec<spin<Dim>, double> arm(const Vec<Dim, double>& r, int a) {
  const Vec<Dim, double> e = Vec<Dim, double>::Unit(a);
  return cross<Dim, double>(r, e);
}

} // namespace

template <int Dim>
auto PlainTransfer<Dim>::samples(int component, const Vec<Dim, double>& x) const -> std::vector<Sample> {
  const Vec<Dim, double> lattice = component_origin<Dim, double>(layout_, component);
  std::array<std::vector<AxisSample>, Dim> axes;
  for (int d = 0; d < Dim; ++d)
    for (int i = 0; i < grid_.extent()[d]; ++i) {
      const double x_i = grid_.dx * (i - Grid<Dim>::pad + lattice[d]), t = (x_i - x[d]) / grid_.dx;
      const bool beyond = x_i < -grid_.dx / 4 || x_i > grid_.size_m()[d] + grid_.dx / 4;
      if (weight(kernel_, t) == 0 || (fault_ == Fault::clamped_kernel && beyond)) continue;
      axes[static_cast<std::size_t>(d)].push_back({i, x_i - x[d], weight(kernel_, t), -slope(kernel_, t) / grid_.dx});
    }
  std::vector<Sample> all{{0, 1, Vec<Dim, double>::Zero(), Vec<Dim, double>::Ones()}};
  for (int d = 0; d < Dim; ++d) { // w_ip = N N N, axis after axis
    std::vector<Sample> longer;
    for (const Sample& row : all)
      for (const AxisSample& i : axes[static_cast<std::size_t>(d)]) {
        Sample s = row;
        s.k += static_cast<std::size_t>(i.index * grid_.stride(d));
        s.w *= i.N;
        s.r[d] = i.r;
        for (int e = 0; e < Dim; ++e) s.gradient[e] *= e == d ? i.slope : i.N;
        longer.push_back(s);
      }
    all = std::move(longer);
  }
  if (fault_ == Fault::clamped_kernel) {
    double sum = 0;
    for (const Sample& s : all) sum += s.w;
    for (Sample& s : all) s.w /= sum;
  }
  return all;
}

template <int Dim> Mat<Dim, double> PlainTransfer<Dim>::D(int component, const Vec<Dim, double>& x) const {
  Mat<Dim, double> sum = Mat<Dim, double>::Zero();
  for (const Sample& s : samples(component, x)) sum += s.w * s.r * s.r.transpose();
  return sum;
}

template <int Dim> Mat<spin<Dim>, double> PlainTransfer<Dim>::K(const Particle& p) const {
  Mat<spin<Dim>, double> sum = Mat<spin<Dim>, double>::Zero();
  for (int a = 0; a < Dim; ++a)
    for (const Sample& s : samples(a, p.x)) {
      const auto rxe = arm<Dim>(s.r, a);
      sum += s.w * p.m * rxe * rxe.transpose();
    }
  return sum;
}

template <int Dim> Vec<spin<Dim>, double> PlainTransfer<Dim>::omega(const Particle& p) const {
  if (mode_ != AffineMode::rigid) return Vec<spin<Dim>, double>::Zero();
  return K(p).inverse() * p.L;
}

template <int Dim> Mat<Dim, double> PlainTransfer<Dim>::C(const Particle& p) const {
  Mat<Dim, double> gradient = Mat<Dim, double>::Zero();
  if (mode_ == AffineMode::full)
    for (int a = 0; a < Dim; ++a) gradient.row(a) = p.B.row(a) * D(a, p.x).inverse();
  return gradient;
}

template <int Dim> void PlainTransfer<Dim>::to_grid(const Particles& particles, Fields& m, Fields& momentum) const {
  m.resize(grid_);
  momentum.resize(grid_);
  for (const Particle& p : particles) {
    const Vec<spin<Dim>, double> w = omega(p);
    const Mat<Dim, double> gradient = C(p);
    for (int a = 0; a < Dim; ++a)
      for (const Sample& s : samples(a, p.x)) {
        const double v = p.v[a] + w.dot(arm<Dim>(s.r, a)) + gradient.row(a).dot(s.r);
        m[static_cast<std::size_t>(a)][s.k] += s.w * p.m;
        momentum[static_cast<std::size_t>(a)][s.k] += s.w * p.m * v;
      }
  }
}

template <int Dim> void PlainTransfer<Dim>::to_particles(const Fields& v, Particles& particles) const {
  for (Particle& p : particles) {
    p.v.setZero();
    p.L.setZero();
    p.B.setZero();
    for (int a = 0; a < Dim; ++a) {
      const Field<double>& component = v[static_cast<std::size_t>(a)];
      Vec<Dim, double> gradient = Vec<Dim, double>::Zero();
      for (const Sample& s : samples(a, p.x)) {
        p.v[a] += s.w * component[s.k];
        if (mode_ == AffineMode::rigid) p.L += s.w * p.m * arm<Dim>(s.r, a) * component[s.k];
        if (mode_ == AffineMode::full) p.B.row(a) += s.w * component[s.k] * s.r.transpose();
        gradient += component[s.k] * s.gradient;
      }
      if (fault_ == Fault::gradient_form) p.B.row(a) = gradient.transpose() * D(a, p.x);
    }
  }
}

template <int Dim>
Totals<Dim> PlainTransfer<Dim>::totals(const Particles& particles, const Vec<Dim, double>& origin) const {
  Totals<Dim> sum;
  for (const Particle& p : particles) {
    sum.momentum += p.m * p.v;
    sum.angular_momentum += cross<Dim, double>(p.x - origin, p.m * p.v) + p.L;
    for (int a = 0; a < Dim; ++a)
      for (int b = 0; b < Dim; ++b) // B^T : epsilon
        if (a != b) sum.angular_momentum[cross_axis<Dim>(a, b)] += p.m * cross_sign<Dim>(a, b) * p.B(b, a);
  }
  return sum;
}

template <int Dim> Vec<Dim, double> PlainTransfer<Dim>::velocity(const Fields& v, const Vec<Dim, double>& x) const {
  Vec<Dim, double> sum = Vec<Dim, double>::Zero();
  for (int a = 0; a < Dim; ++a)
    for (const Sample& s : samples(a, x)) sum[a] += s.w * v[static_cast<std::size_t>(a)][s.k];
  return sum;
}

template <int Dim>
template <class Real>
auto PlainTransfer<Dim>::from_solver(const flipbook::Particles<Dim, Real>& particles) const -> Particles {
  Particles plain(particles.size());
  for (std::size_t q = 0; q < plain.size(); ++q) {
    Particle& p = plain[q];
    p.m = static_cast<double>(particles.m[q]);
    p.x = particles.position(q).template cast<double>();
    p.v = particles.velocity(q).template cast<double>();
    if (mode_ == AffineMode::rigid) {
      Vec<spin<Dim>, double> w;
      for (int c = 0; c < spin<Dim>; ++c) w[c] = static_cast<double>(particles.A[static_cast<std::size_t>(c)][q]);
      p.L = K(p) * w;
    }
    if (mode_ != AffineMode::full) continue;
    for (int a = 0; a < Dim; ++a) {
      Vec<Dim, double> row;
      for (int d = 0; d < Dim; ++d) row[d] = static_cast<double>(particles.A[static_cast<std::size_t>(a * Dim + d)][q]);
      p.B.row(a) = row.transpose() * D(a, p.x);
    }
  }
  return plain;
}

template <int Dim> std::vector<double> PlainTransfer<Dim>::solver_state(const Particle& p) const {
  std::vector<double> state;
  if (mode_ == AffineMode::rigid)
    for (const double w : omega(p)) state.push_back(w);
  if (mode_ == AffineMode::full) {
    const Mat<Dim, double> gradient = C(p);
    for (int a = 0; a < Dim; ++a)
      for (int d = 0; d < Dim; ++d) state.push_back(gradient(a, d));
  }
  return state;
}

template class PlainTransfer<2>;
template class PlainTransfer<3>;
#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template std::vector<PlainParticle<Dim>> PlainTransfer<Dim>::from_solver(const flipbook::Particles<Dim, Real>&) const
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
