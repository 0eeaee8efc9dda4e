// SPDX-License-Identifier: MIT
#include "sim/fluid/fluid_solver.h"

#include "sim/fluid/advect.h"
#include "sim/fluid/energy.h"
#include "sim/fluid/level_set.h"
#include "sim/fluid/spacing.h"
#include "sim/transfer/transfer.h"

#include <cmath>
#include <utility>

namespace flipbook {

// === Setting up

template <int Dim, class Real>
FluidSolver<Dim, Real>::FluidSolver(const Settings& settings, Particles<Dim, Real> particles, Pool& pool,
                                    std::vector<Obstacle> obstacles)
    : pool_(pool), state_(settings, grid_of<Dim>(settings), std::move(particles), std::move(obstacles)),
      recorder_(state_.particles) {
  check_finite();
  place_solids(0);
  state_.particles.set_mode(settings.transfer.corner().mode);
  find_liquid();
  particles_to_grid();
  gather_affine_state();
}

template <int Dim, class Real> std::vector<Parameter> FluidSolver<Dim, Real>::parameters() const {
  Settings settings = state_.settings;
  return parameters_of(settings);
}

template <int Dim, class Real> Refusal FluidSolver<Dim, Real>::set(std::string_view path, const Value& value) {
  for (const Parameter& p : parameters())
    if (p.path == path && p.effect == Effect::restart) return {p.path + " cannot change during a run", ""};
  Settings next = state_.settings;
  if (Refusal r = set_parameter(next, path, value); !r.message.empty()) return r;
  if (const auto conflict = next.conflict(); !conflict.message.empty()) return {conflict.message, ""};
  const TransferSettings before = std::exchange(state_.settings, next).transfer;
  if (next.transfer.corner().mode != before.corner().mode || next.transfer.kernel != before.kernel)
    gather_affine_state();
  return {};
}

/// Particles that remember more than before find it in the velocity of the grid.
template <int Dim, class Real> void FluidSolver<Dim, Real>::gather_affine_state() {
  auto& s = state_;
  const auto& transfer = s.settings.transfer;
  s.particles.set_mode(transfer.corner().mode);
  gather_affine(transfer.corner(), transfer.kernel, Layout::mac, s.grid, s.u, s.particles, pool_);
}

// === The step

template <int Dim, class Real> void FluidSolver<Dim, Real>::step(double dt) {
  if (state_.settings.time.splitting == Splitting::midpoint)
    midpoint(dt);
  else
    lie(dt);
  keep_apart();
  state_.time += dt;
  state_.last_dt = dt;
  ++state_.steps;
  check_finite();
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::lie(double dt) {
  const double t = state_.time;
  state_.solids.give_velocity(t, t + dt, state_.walls, pool_);
  find_liquid();                   // where phi < 0
  particles_to_grid();             // u_i = sum_p w m (v_p + A_p (x_i - x_p)) / m_i,  u_old = u
  add_gravity(dt);                 // u <- u + dt g
  project(dt, state_.p);           // div u = 0
  grid_to_particles(dt, state_.u); // v, A by the scheme
  advect(dt, state_.u);            // dx/dt = u
  place_solids(t + dt);
}

/// Second order: half of the motion, the forces as a reflection about the middle, the other half. The projection that
/// opens the step removes the divergence that the last motion left, as a correction of the particles: it costs no
/// blending.
template <int Dim, class Real> void FluidSolver<Dim, Real>::midpoint(double dt) {
  const double t = state_.time;
  state_.solids.give_velocity(t, t + dt / 2, state_.walls, pool_);
  find_liquid();
  particles_to_grid();
  project(dt, correction_pressure_);
  correct_particles();   // v <- v + S (u - u_old)
  u_opening_ = state_.u; // at the start of the step
  advect(dt / 2, u_opening_);
  place_solids(t + dt / 2);

  state_.solids.give_velocity(t, t + dt, state_.walls, pool_);
  find_liquid();
  particles_to_grid();
  add_gravity(dt / 2);
  project(dt / 2, state_.p); // u in the middle
  combine(2, -1, state_.u_old);
  state_.walls.pad(blend_);
  grid_to_particles(dt, blend_); // from u_old to u_old + 2 (u - u_old)
  combine(2, -1, u_opening_);    // 2 u - u_opening, the velocity at the end
  advect(dt / 2, blend_);
  place_solids(t + dt);
}

// === Its parts

template <int Dim, class Real> void FluidSolver<Dim, Real>::find_liquid() {
  auto& s = state_;
  sort_by_cell(s.particles, s.grid, s.order, pool_);
  const double radius = particle_radius<Dim>(s.grid.dx, s.settings.seeding.per_axis);
  level_set(s.grid, s.walls, s.particles, s.order, radius, s.phi, pool_);
  s.solids.extend(s.walls, s.phi);
  const Surface surface = s.settings.fluid.surface;
  s.cells.classify(surface, s.grid, s.walls, s.order, s.phi, pool_,
                   surface == Surface::voxel ? s.solids.wet(s.walls, s.order) : std::vector<std::size_t>{});
  s.cells.mark_ballistic(s.grid, s.order, s.ballistic, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::particles_to_grid() {
  auto& s = state_;
  const auto& transfer = s.settings.transfer;
  if (s.settings.ledger.on) kinetic_before_ = kinetic_energy(s, pool_);
  p2g(transfer.corner(), transfer.kernel, Layout::mac, s.grid, s.particles, s.order, s.m, s.u, pool_);
  s.walls.fold(s.m);
  s.walls.fold(s.u);
  to_velocity(s.m, s.u, pool_);
  extrapolate_over_air(true, s.u);
  s.walls.pad_slip(s.u);
  s.u_old = s.u;
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::add_gravity(double dt) {
  for (std::size_t a = 0; a < Dim; ++a) {
    const Real du = static_cast<Real>(dt * state_.settings.fluid.gravity[a]);
    if (du != 0)
      for (Real& u : state_.u[a]) u += du;
  }
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::project(double dt, Field<double>& p) {
  auto& s = state_;
  s.walls.close(s.u, pool_);
  s.solids.before_projection(s.u);
  s.solve = projection_(s.grid, s.walls, s.cells, s.settings.pressure, s.settings.fluid.density, dt, s.u, p, pool_);
  s.solids.carry_change(s.walls, s.cells, s.m, s.u, pool_);
  extrapolate_over_air(false, s.u);
  s.walls.close(s.u, pool_);
  s.walls.pad(s.u);
  if (s.solids.none()) return;
  s.solids.constrain(s.walls, s.u, pool_);
  s.walls.pad(s.u);
}

template <int Dim, class Real>
void FluidSolver<Dim, Real>::grid_to_particles(double dt, const Components<Dim, Real>& u) {
  auto& s = state_;
  const auto& transfer = s.settings.transfer;
  const Corner corner = transfer.corner();
  measured(u, [&] {
    if (corner.order > 1) return gather_filtered(corner, u);
    g2p(corner, transfer.kernel, Layout::mac, s.grid, u, s.u_old, s.particles, pool_, &s.ballistic);
  });
  accelerate_ballistic(s.settings.fluid.gravity, dt, s.ballistic, s.particles, pool_);
}

/// XPIC: the terms beyond the first ride on the velocity that is gathered.
template <int Dim, class Real>
void FluidSolver<Dim, Real>::gather_filtered(const Corner& corner, const Components<Dim, Real>& u) {
  auto& s = state_;
  const KernelName kernel = s.settings.transfer.kernel;
  const auto fold = [&](Components<Dim, Real>& sums) { s.walls.fold(sums); };
  const Components<Dim, Real>& terms =
      xpic_(corner.order, kernel, Layout::mac, s.grid, s.particles, s.order, s.u_old, fold, pool_);
  Components<Dim, Real> filtered = u;
  for (std::size_t d = 0; d < Dim; ++d)
    pool_.ranges(s.grid.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        filtered[d][i] += terms[d][i];
    });
  g2p(corner, kernel, Layout::mac, s.grid, filtered, s.u_old, s.particles, pool_, &s.ballistic);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::correct_particles() {
  auto& s = state_;
  const auto& transfer = s.settings.transfer;
  combine(1, -1, s.u_old);
  measured(s.u, [&] {
    g2p_increment(transfer.corner(), transfer.kernel, Layout::mac, s.grid, blend_, s.particles, pool_, &s.ballistic);
  });
}

template <int Dim, class Real>
void FluidSolver<Dim, Real>::combine(Real a, Real b, const Components<Dim, Real>& other) {
  blend_.resize(state_.grid);
  for (std::size_t d = 0; d < Dim; ++d)
    pool_.ranges(state_.grid.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        blend_[d][i] = a * state_.u[d][i] + b * other[d][i];
    });
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::advect(double dt, const Components<Dim, Real>& u) {
  auto& s = state_;
  flipbook::advect(s.settings.time.advection, s.settings.transfer.kernel, s.grid, s.walls, u, dt, s.ballistic,
                   s.particles, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::keep_apart() {
  auto& s = state_;
  const double strength = s.settings.fluid.spacing;
  if (strength == 0) return;
  sort_by_cell(s.particles, s.grid, s.order, pool_);
  correct_spacing(strength, s.grid.dx / s.settings.seeding.per_axis, s.grid, s.walls, s.order, s.particles, pool_);
  s.solids.push_out(s.walls, s.ballistic, s.particles, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::place_solids(double t) {
  auto& s = state_;
  s.solids.place(t, s.walls, pool_);
  s.solids.push_out(s.walls, s.ballistic, s.particles, pool_);
}

/// Known are the faces of liquid cells; of those only the ones with mass before the projection has given the others a
/// value, which it does not to faces in obstacles.
template <int Dim, class Real>
void FluidSolver<Dim, Real>::extrapolate_over_air(bool massless_too, Components<Dim, Real>& u) {
  const auto& s = state_;
  Known<Dim> known;
  for (std::size_t a = 0; a < Dim; ++a) {
    known[a].resize(u[a].size());
    const auto& buried = s.walls.buried[a];
    pool_.ranges(s.grid.size(), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        known[a][i] =
            s.cells.inverse_theta[a][i] > 0 && ((!massless_too && (buried.empty() || !buried[i])) || s.m[a][i] > 0);
    });
  }
  // A particle may cross cfl cells within a step, and a cubic stencil reaches two cells beyond its own.
  const int layers = 2 + std::max(1, static_cast<int>(std::ceil(s.settings.time.cfl)));
  extrapolate(s.grid, s.walls, std::move(known), layers, u, pool_);
}

template <int Dim, class Real>
template <class Transfer>
void FluidSolver<Dim, Real>::measured(const Components<Dim, Real>& u, Transfer&& transfer) {
  if (!state_.settings.ledger.on) return transfer();
  const double gain = grid_gain(state_, u, energies_, pool_);
  transfer();
  transfer_loss_ += kinetic_before_ - kinetic_energy(state_, pool_) + gain;
}

// === Bounds and checks

template <int Dim, class Real> double FluidSolver<Dim, Real>::max_dt() const {
  const auto& s = state_;
  const auto count = static_cast<std::int64_t>(s.particles.size());
  constexpr std::int64_t grain = 8192;
  std::vector<double> fastest(static_cast<std::size_t>((count + grain - 1) / grain), 0.0);
  pool_.ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
    Real square = 0;
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      square = std::max(square, s.particles.velocity(p).squaredNorm());
    fastest[static_cast<std::size_t>(begin / grain)] = std::sqrt(static_cast<double>(square));
  });
  double speed = 0, gravity = 0;
  for (const double v : fastest) speed = std::max(speed, v);
  for (int a = 0; a < Dim; ++a) {
    gravity = std::hypot(gravity, s.settings.fluid.gravity[static_cast<std::size_t>(a)]);
    if (s.steps == 0) continue;
    const auto& u = s.u[static_cast<std::size_t>(a)];
    for (std::size_t i = 0; i < u.size(); ++i)
      if (s.cells.inverse_theta[static_cast<std::size_t>(a)][i] > 0 && s.walls.open[static_cast<std::size_t>(a)][i] > 0)
        speed = std::max(speed, std::abs(static_cast<double>(u[i])));
  }
  const double dx = s.grid.dx, bound = s.settings.time.dt;
  const double dt = s.settings.time.cfl * dx / std::max(speed + std::sqrt(gravity * dx), 1e-30);
  return s.solids.max_dt(s.time, s.settings.time.cfl, bound > 0 ? std::min(bound, dt) : dt, s.walls);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::check_finite() const {
  const auto& particles = state_.particles;
  const auto count = static_cast<std::int64_t>(particles.size());
  const auto bad = [&](std::size_t p) {
    Real zero = 0; // stays zero unless something is not finite
    for (std::size_t d = 0; d < Dim; ++d) zero += 0 * particles.x[d][p] + 0 * particles.v[d][p];
    for (const auto& column : particles.A) zero += 0 * column[p];
    return zero != 0;
  };
  pool_.ranges(count, 8192, [&](std::int64_t begin, std::int64_t end) {
    for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      if (bad(p)) throw NonFiniteError(title(), state_.steps, state_.time, particles.id[p]);
  });
}

template class FluidSolver<2, float>;
template class FluidSolver<2, double>;
template class FluidSolver<3, float>;
template class FluidSolver<3, double>;

} // namespace flipbook
