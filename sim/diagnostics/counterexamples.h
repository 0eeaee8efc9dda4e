// SPDX-License-Identifier: MIT
// COUNTEREXAMPLES: nothing here is used by a solver, and what bears the name of a fault is wrong on purpose.
//
// The transfers of the tech report of APIC as it writes them, in double, as plain sums over all particles and samples;
// to be read beside the report. With w_ip = N((x_i - x_p) / dx), a product over the axes, and r = x_i - x_p:
//
//   (1) RPIC  K_p = sum_i w_ip m_p r* r*^T      m_i v_i = sum_p w_ip m_p (v_p + (K_p^-1 L_p) x r)
//   (2)       v_p = sum_i w_ip v~_i             L_p = sum_i w_ip r x m_p v~_i
//   (3) APIC  D_p = sum_i w_ip r r^T            m_i v_i = sum_p w_ip m_p (v_p + B_p D_p^-1 r)
//   (4)       v_p = sum_i w_ip v~_i             B_p = sum_i w_ip v~_i r^T
//
// On MAC faces each component has samples, weights and D_p of its own, and r* becomes the sum over components of
// r x e_a. Without a fault these are the solver's transfers to rounding, which `flipbook verify` checks (T.1, T.2).
#pragma once

#include "sim/core/field.h"
#include "sim/core/particles.h"
#include "sim/diagnostics/ledger.h"
#include "sim/kernels/kernels.h"

#include <vector>

namespace flipbook {

enum class Fault {
  none,
  gradient_form,  ///< C_p = sum_i v~_i (grad w_ip)^T in (4), kept as B_p = C_p D_p
  clamped_kernel, ///< samples beyond a wall are dropped and the other weights divided by their sum: sum w x_i != x_p
};

/// What the report stores of a particle. The solver keeps K^-1 L and B D^-1 instead.
template <int Dim> struct PlainParticle {
  double m = 0;
  Vec<Dim, double> x, v;
  Vec<spin<Dim>, double> L = Vec<spin<Dim>, double>::Zero(); ///< RPIC; with the mass
  Mat<Dim, double> B = Mat<Dim, double>::Zero();             ///< APIC; without the mass
};

template <int Dim> class PlainTransfer {
public:
  using Particle = PlainParticle<Dim>;
  using Particles = std::vector<Particle>;
  using Fields = Components<Dim, double>;

  /// Positions keep away from planes through samples, where D_p and K_p of the linear kernel have no inverse.
  PlainTransfer(AffineMode mode, KernelName kernel, Layout layout, const Grid<Dim>& grid, Fault fault = Fault::none)
      : mode_(mode), kernel_(kernel), layout_(layout), grid_(grid), fault_(fault) {}

  /// What the report would store where the solver stores omega_p or C_p, and back.
  template <class Real> [[nodiscard]] Particles from_solver(const flipbook::Particles<Dim, Real>& particles) const;
  [[nodiscard]] std::vector<double> solver_state(const Particle& p) const;

  /// (1) or (3): masses, and momenta m_i v_i.
  void to_grid(const Particles& particles, Fields& m, Fields& momentum) const;
  /// (2) or (4).
  void to_particles(const Fields& v, Particles& particles) const;

  /// Definitions 3.5 and 4.1 or 5.1: sum x_p x m_p v_p + L_p, or + m_p B_p^T : epsilon. Mass and energy stay 0.
  [[nodiscard]] Totals<Dim> totals(const Particles& particles, const Vec<Dim, double>& origin) const;

  /// The grid's velocity at any point: sum_i w_i(x) v_i.
  [[nodiscard]] Vec<Dim, double> velocity(const Fields& v, const Vec<Dim, double>& x) const;
  /// FAULT, second order though it is: x_p^{n+1} - x_p^n = dt v(x_p + dt/2 v(x_p)) is not parallel to v_p^{n+1} =
  /// v(x_p).
  [[nodiscard]] Vec<Dim, double> midpoint_move(const Fields& v, const Vec<Dim, double>& x, double dt) const {
    return dt * velocity(v, x + dt / 2 * velocity(v, x));
  }

private:
  struct Sample {
    std::size_t k; ///< place in the field
    double w;
    Vec<Dim, double> r, gradient; ///< x_i - x_p, and grad w_ip by x_p
  };
  [[nodiscard]] std::vector<Sample> samples(int component, const Vec<Dim, double>& x) const;
  [[nodiscard]] Mat<Dim, double> D(int component, const Vec<Dim, double>& x) const;
  [[nodiscard]] Mat<spin<Dim>, double> K(const Particle& p) const;
  [[nodiscard]] Vec<spin<Dim>, double> omega(const Particle& p) const;
  [[nodiscard]] Mat<Dim, double> C(const Particle& p) const;

  AffineMode mode_;
  KernelName kernel_;
  Layout layout_;
  Grid<Dim> grid_;
  Fault fault_;
};

} // namespace flipbook
