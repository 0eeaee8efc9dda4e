// SPDX-License-Identifier: MIT
#include "sim/diagnostics/measurement.h"

#include "sim/diagnostics/bench.h"
#include "sim/diagnostics/counterexamples.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

/// |after - before| against the scale; of the energy the change itself.
template <int Dim>
double difference(Quantity quantity, const Totals<Dim>& before, const Totals<Dim>& after, const Scale& scale) {
  switch (quantity) {
  case Quantity::mass: return std::abs(after.mass - before.mass) / before.mass;
  case Quantity::momentum: return (after.momentum - before.momentum).norm() / scale.momentum;
  case Quantity::energy: return (after.kinetic_energy - before.kinetic_energy) / before.kinetic_energy;
  default: return (after.angular_momentum - before.angular_momentum).norm() / scale.angular;
  }
}

/// The largest difference of two numbers against the largest number.
struct Worst {
  double difference = 0, largest = 0;
  void add(double expected, double found) {
    keep_worst(difference, std::abs(found - expected));
    keep_worst(largest, std::abs(expected));
  }
  [[nodiscard]] double relative() const { return difference / largest; }
};

double larger(double a, double b) {
  keep_worst(a, b);
  return a;
}

template <int Dim, class From> Components<Dim, double> in_double(const Components<Dim, From>& field) {
  Components<Dim, double> copy;
  for (std::size_t a = 0; a < Dim; ++a) copy[a].assign(field[a].begin(), field[a].end());
  return copy;
}

template <int Dim, class Real> class Measurement {
public:
  Measurement(const Claim& claim, KernelName kernel, Layout layout, std::uint64_t seed, Pool& pool)
      : claim_(claim), b_(claim.corner, kernel, layout, seed, pool), dt_(b_.trial.grid.dx / 2) {}

  [[nodiscard]] double error() {
    switch (claim_.check) {
    case Check::to_grid: return to_grid();
    case Check::round_trips: return round_trips(b_.corner.mode == AffineMode::rigid);
    case Check::rigid_trips: return round_trips(true);
    case Check::affine_trips: return round_trips(false);
    case Check::own_field: return own_field();
    case Check::plain_p2g: return plain_p2g();
    case Check::plain_g2p: return plain_g2p();
    case Check::gradient_form: return gradient_form();
    case Check::clamped_kernel: return clamped_kernel();
    case Check::to_particles:
    case Check::idle_grid:
    case Check::midpoint_move:
    default: return to_particles();
    }
  }

private:
  [[nodiscard]] double to_grid() {
    b_.scatter();
    return difference(claim_.quantity, b_.on_particles(), b_.on_grid(b_.u), b_.scale());
  }

  /// Over a step dt: samples and particles move, and the angular momentum is that of where they arrive. B_p and L_p are
  /// about x_p^n in both schemes, so only the moment of v_p^{n+1} changes with the position.
  [[nodiscard]] double to_particles() {
    b_.scatter();
    const Components<Dim, Real> v = claim_.check == Check::idle_grid ? b_.u : b_.trial.random_field(0);
    Totals<Dim> grid = b_.on_grid(v);
    grid.angular_momentum = b_.moved_angular_momentum(v, dt_);
    b_.gather(v);
    Totals<Dim> particles = b_.on_particles();
    const Components<Dim, double> field = in_double<Dim>(v);
    for (std::size_t p = 0; p < b_.trial.particles.size(); ++p) {
      const Vec<Dim, double> momentum =
          static_cast<double>(b_.trial.particles.m[p]) * b_.trial.particles.velocity(p).template cast<double>();
      particles.angular_momentum += cross<Dim, double>(displacement(p, field), momentum);
    }
    return difference(claim_.quantity, grid, particles, b_.scale());
  }

  /// x_p^{n+1} - x_p^n, as the positions store it.
  [[nodiscard]] Vec<Dim, double> displacement(std::size_t p, const Components<Dim, double>& v) const {
    const Vec<Dim, Real> x = b_.trial.particles.position(p);
    if (claim_.check == Check::midpoint_move) return plain().midpoint_move(v, x.template cast<double>(), dt_);
    const Vec<Dim, Real> moved = x + static_cast<Real>(dt_) * b_.trial.particles.velocity(p);
    return moved.template cast<double>() - x.template cast<double>();
  }

  [[nodiscard]] double round_trips(bool rigid) {
    const Components<Dim, Real> field = b_.trial.affine_field(b_.layout, rigid);
    b_.u = field;
    for (int n = 0; n < claim_.cycles; ++n) {
      b_.gather(b_.u);
      b_.scatter();
    }
    return b_.field_error(field, b_.u);
  }

  [[nodiscard]] double own_field() {
    const auto field = b_.trial.affine_field(b_.layout, b_.corner.mode == AffineMode::rigid);
    b_.scatter(); // for the masses
    b_.gather(field);
    return std::abs(difference(Quantity::energy, b_.on_grid(field), b_.on_particles(), {}));
  }

  [[nodiscard]] PlainTransfer<Dim> plain(Fault fault = Fault::none) const {
    return {claim_.corner.mode, b_.kernel, b_.layout, b_.trial.grid, fault};
  }

  [[nodiscard]] double plain_p2g() {
    Components<Dim, double> m, momentum;
    plain().to_grid(plain().from_solver(b_.trial.particles), m, momentum);
    p2g(b_.corner, b_.kernel, b_.layout, b_.trial.grid, b_.trial.particles, b_.trial.order, b_.m, b_.u, b_.pool);
    Worst masses, momenta;
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t k = 0; k < m[a].size(); ++k) {
        masses.add(m[a][k], static_cast<double>(b_.m[a][k]));
        momenta.add(momentum[a][k], static_cast<double>(b_.u[a][k]));
      }
    return larger(masses.relative(), momenta.relative());
  }

  [[nodiscard]] double plain_g2p() {
    const Components<Dim, Real> v = b_.trial.random_field(0);
    auto particles = plain().from_solver(b_.trial.particles);
    plain().to_particles(in_double<Dim>(v), particles);
    b_.gather(v);
    Worst velocities, affine;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const Vec<Dim, Real> found = b_.trial.particles.velocity(p);
      for (int d = 0; d < Dim; ++d) velocities.add(particles[p].v[d], static_cast<double>(found[d]));
      const std::vector<double> state = plain().solver_state(particles[p]);
      for (std::size_t c = 0; c < state.size(); ++c)
        affine.add(state[c], static_cast<double>(b_.trial.particles.A[c][p]));
    }
    return larger(velocities.relative(), affine.relative());
  }

  [[nodiscard]] double gradient_form() {
    const PlainTransfer<Dim> faulty = plain(Fault::gradient_form);
    b_.scatter(); // for the masses
    const Components<Dim, Real> v = b_.trial.random_field(0);
    auto particles = faulty.from_solver(b_.trial.particles);
    faulty.to_particles(in_double<Dim>(v), particles);
    b_.gather(v); // for the scale: the velocities are the same
    return difference(claim_.quantity, b_.on_grid(v), faulty.totals(particles, b_.trial.origin), b_.scale());
  }

  [[nodiscard]] double clamped_kernel() {
    const PlainTransfer<Dim> faulty = plain(Fault::clamped_kernel);
    const auto particles = faulty.from_solver(b_.trial.particles);
    Components<Dim, double> m, v;
    faulty.to_grid(particles, m, v);
    to_velocity(m, v, b_.pool);
    const Totals<Dim> grid = grid_totals(b_.layout, b_.trial.grid, m, v, b_.trial.origin, b_.pool);
    return difference(claim_.quantity, faulty.totals(particles, b_.trial.origin), grid, b_.scale());
  }

  const Claim& claim_;
  Bench<Dim, Real> b_;
  double dt_; ///< grid speeds are at most 1: half a cell
};

} // namespace

template <int Dim, class Real>
double measure(const Claim& claim, KernelName kernel, Layout layout, std::uint64_t seed, Pool& pool) {
  if (claim.check == Check::cycles || claim.check == Check::carried_gradient)
    return measure_cycles<Dim, Real>(claim, kernel, layout, seed, pool);
  return Measurement<Dim, Real>(claim, kernel, layout, seed, pool).error();
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template double measure<Dim, Real>(const Claim&, KernelName, Layout, std::uint64_t, Pool&)
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
