// SPDX-License-Identifier: MIT
// Momentum and angular momentum over many cycles of P2G, a change of the grid's velocity, G2P and a move along the
// particles' velocities. What remains at the end, less what the changes of the grid put in, is the error:
//   drift = L_P(end) - L_P(begin) - sum over cycles of (L_G after the change - L_G before it)
#include "sim/diagnostics/bench.h"
#include "sim/diagnostics/measurement.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

constexpr int room = 3; ///< empty cells around the particles, for their moves

template <int Dim, class Real> class Cycles {
public:
  /// Odd seeds change the grid in every cycle, even ones never do.
  Cycles(const Claim& claim, KernelName kernel, Layout layout, std::uint64_t seed, Pool& pool)
      : claim_(claim), b_(claim.corner, kernel, layout, seed, pool, room), changes_(seed % 2 == 1) {}

  [[nodiscard]] double error() {
    const Scale scale = b_.scale();
    const Totals<Dim> begin = b_.on_particles();
    for (int n = 0; n < claim_.cycles; ++n) step(n);
    const Totals<Dim> end = b_.on_particles();
    if (claim_.quantity == Quantity::momentum)
      return (end.momentum - begin.momentum - given_.momentum).norm() / scale.momentum;
    return (end.angular_momentum - begin.angular_momentum - given_.angular_momentum).norm() / scale.angular;
  }

private:
  void step(int n) {
    b_.scatter();
    Components<Dim, Real> v = b_.u;
    if (changes_) change(v, n);
    b_.gather(v);
    move();
    sort_by_cell(b_.trial.particles, b_.trial.grid, b_.trial.order, b_.pool);
  }

  /// Stands for the forces: every sample's velocity changes by up to a tenth of the particles' first speed.
  void change(Components<Dim, Real>& v, int n) {
    const Totals<Dim> before = b_.on_grid(v);
    for (std::size_t a = 0; a < Dim; ++a)
      for (std::size_t k = 0; k < v[a].size(); ++k)
        if (b_.m[a][k] > 0)
          v[a][k] += static_cast<Real>(b_.trial.number(200 + static_cast<std::uint64_t>(n), k, a, -0.1, 0.1));
    const Totals<Dim> after = b_.on_grid(v);
    given_.momentum += after.momentum - before.momentum;
    given_.angular_momentum += after.angular_momentum - before.angular_momentum;
  }

  /// x_p += dt v_p. With the linear kernel D_p depends on the place in the cell: the report keeps B_p = C_p D_p, the
  /// solver keeps C_p (B_p D_p^-1 at the new place has no bound), so the move itself changes B_p. That is no transfer's
  /// doing and is counted as given.
  void move() {
    auto& p = b_.trial.particles;
    const bool carries = b_.kernel == KernelName::linear && claim_.check != Check::carried_gradient;
    const Totals<Dim> before = carries ? b_.on_particles() : Totals<Dim>();
    const double dt = longest_step();
    for (std::size_t q = 0; q < p.size(); ++q) {
      const Vec<Dim, Real> x = p.position(q), v = p.velocity(q);
      p.set_position(q, x + static_cast<Real>(dt) * v);
      if (!carries) continue; // the moment of the velocity itself stays in the account
      const Vec<Dim, double> moved = p.position(q).template cast<double>() - x.template cast<double>();
      given_.angular_momentum -= static_cast<double>(p.m[q]) * cross<Dim, double>(moved, v.template cast<double>());
    }
    if (carries) given_.angular_momentum += b_.on_particles().angular_momentum - before.angular_momentum;
  }

  /// A twentieth of a cell for a particle of speed 1; less where a particle would leave the box. The propositions hold
  /// for every dt.
  [[nodiscard]] double longest_step() const {
    const auto& p = b_.trial.particles;
    double dt = b_.trial.grid.dx / 20;
    for (std::size_t q = 0; q < p.size(); ++q)
      for (int d = 0; d < Dim; ++d) {
        const double x = static_cast<double>(p.position(q)[d]), v = static_cast<double>(p.velocity(q)[d]);
        const double free = v > 0 ? b_.trial.grid.size_m()[d] - x : x;
        dt = std::min(dt, std::max(0.0, free - 0.01 * b_.trial.grid.dx) / std::max(std::abs(v), 1e-12));
      }
    return dt;
  }

  const Claim& claim_;
  Bench<Dim, Real> b_;
  bool changes_;
  Totals<Dim> given_; ///< by everything that is not a transfer
};

} // namespace

template <int Dim, class Real>
double measure_cycles(const Claim& claim, KernelName kernel, Layout layout, std::uint64_t seed, Pool& pool) {
  return Cycles<Dim, Real>(claim, kernel, layout, seed, pool).error();
}

#define FLIPBOOK_INSTANTIATE(Dim, Real)                                                                                \
  template double measure_cycles<Dim, Real>(const Claim&, KernelName, Layout, std::uint64_t, Pool&)
FLIPBOOK_INSTANTIATE(2, float);
FLIPBOOK_INSTANTIATE(2, double);
FLIPBOOK_INSTANTIATE(3, float);
FLIPBOOK_INSTANTIATE(3, double);

} // namespace flipbook
