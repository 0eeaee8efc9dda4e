// SPDX-License-Identifier: MIT
#include "sim/fluid/fluid_solver.h"

#include "sim/core/check_finite.h"
#include "sim/fluid/liquid.h"
#include "sim/fluid/spacing.h"
#include "sim/transfer/transfer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook {

static constexpr std::int64_t samples_per_chunk = 1 << 14;

// === Setting up

template <int Dim, class Real>
FluidSolver<Dim, Real>::FluidSolver(const Settings& settings, Particles<Dim, Real> particles, Pool& pool,
                                    std::vector<Obstacle> obstacles, std::unique_ptr<StageHook<Dim, Real>> hook)
    : pool_(pool), state_(settings, grid_of<Dim>(settings), std::move(particles), std::move(obstacles)),
      recorder_(state_.particles) {
  check_finite(
      state_.particles, [&] { return title(); }, state_.steps, state_.time, pool_);
  place_solids(0);
  state_.particles.set_mode(settings.transfer.corner().mode);
  find_liquid();
  particles_to_grid();
  gather_affine_state();
  if (settings.ledger.on) ledger_.emplace(state_, pool_);
  hook_ = std::move(hook); // the start is always right
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
  const Settings before = std::exchange(state_.settings, next);
  if (next.transfer.corner().mode != before.transfer.corner().mode || next.transfer.kernel != before.transfer.kernel) {
    gather_affine_state();
    if (ledger_) ledger_->rebook(Stage::g2p, state_, pool_);
  } else if (ledger_ && next.fluid.gravity != before.fluid.gravity) {
    ledger_->rebook(Stage::forces, state_, pool_); // another potential
  }
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
  step_dt_ = dt;
  show(StageStill::start);
  if (ledger_) ledger_->begin_step(dt);
  switch (state_.settings.time.splitting) {
  case Splitting::lie: lie(dt); break;
  case Splitting::midpoint: midpoint(dt); break;
  case Splitting::reflection: reflection(dt); break;
  }
  keep_apart();
  show(StageStill::end);
  state_.time += dt;
  state_.last_dt = dt;
  ++state_.steps;
  check_finite(
      state_.particles, [&] { return title(); }, state_.steps, state_.time, pool_);
  const Timed timed(profile_, Phase::ledger);
  if (ledger_) ledger_->end_step(state_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::lie(double dt) {
  const double t = state_.time;
  state_.solids.give_velocity(t, t + dt, state_.walls, pool_);
  find_liquid();               // where phi < 0
  particles_to_grid();         // u_i = sum_p w m (v_p + A_p (x_i - x_p)) / m_i,  u_old = u
  add_gravity(dt);             // u <- u + dt g
  project(dt, state_.p);       // div u = 0
  grid_to_particles(state_.u); // v, A by the scheme
  const auto first = state_.settings.transfer.corner().v_is_u() ? FirstStage::own_velocity : FirstStage::looked_up;
  advect(dt, state_.u, t, first); // dx/dt = u
}

/// Second order: half of the motion, the forces as a reflection about the middle, the other half. The projection that
/// opens the step removes the divergence that the last motion left.
template <int Dim, class Real> void FluidSolver<Dim, Real>::midpoint(double dt) {
  const double t = state_.time, middle = t + dt / 2;
  state_.solids.give_velocity(t, middle, state_.walls, pool_);
  remove_divergence(dt); // v <- v + S (u - u_old)
  u_opening_ = state_.u; // at the start of the step
  advect(dt / 2, u_opening_, t);

  state_.solids.give_velocity(t, t + dt, state_.walls, pool_);
  find_liquid();
  particles_to_grid();
  add_gravity(dt / 2);
  project(dt / 2, state_.p); // u in the middle
  reflect(dt / 2);           // blend = 2 u - u_old
  grid_to_particles(blend_);
  combine(2, -1, u_opening_); // the velocity at the end
  advect(dt / 2, blend_, middle);
}

/// Advection-reflection [Zehnder, Narain, Thomaszewski 2018]: half of the motion along what closed the last step, the
/// forces as a reflection, half of the motion along the velocity reflected about, and a projection to close.
template <int Dim, class Real> void FluidSolver<Dim, Real>::reflection(double dt) {
  const double t = state_.time, middle = t + dt / 2;
  if (state_.steps == 0) {
    state_.solids.give_velocity(t, middle, state_.walls, pool_);
    remove_divergence(dt);
  }
  advect(dt / 2, state_.u, t);

  state_.solids.give_velocity(middle, t + dt, state_.walls, pool_);
  find_liquid();
  particles_to_grid();
  add_gravity(dt / 2);
  project(dt / 2, state_.p);
  reflect(dt / 2);
  grid_to_particles(blend_);
  advect(dt / 2, state_.u, middle);

  state_.solids.give_velocity(t + dt, t + 1.5 * dt, state_.walls, pool_);
  remove_divergence(dt);
}

// === Its parts

/// A stage may come more than once in a step.
template <int Dim, class Real>
template <class Body>
void FluidSolver<Dim, Real>::during(Stage stage, Body&& body, Gather gather) {
  Timed timed(profile_, phase_of(stage));
  if (hook_) hook_->entered(stage, state_);
  body();
  if (hook_) hook_->leaving(stage, state_);
  show(stage);
  timed.turn(Phase::ledger);
  if (ledger_) ledger_->left(stage, state_, stage == Stage::second_half ? blend_ : state_.u, gather, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::find_liquid() {
  auto& s = state_;
  Timed timed(profile_, Phase::sort);
  sort_by_cell(s.particles, s.grid, s.order, pool_);
  timed.turn(Phase::level_set);
  flipbook::find_liquid(s.settings, s.grid, s.walls, s.solids, s.particles, s.order, s.phi, s.cells, pool_);
  s.cells.mark_ballistic(s.grid, s.order, s.ballistic, pool_);
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::particles_to_grid() {
  auto& s = state_;
  during(Stage::p2g, [&] {
    const auto& transfer = s.settings.transfer;
    p2g(transfer.corner(), transfer.kernel, Layout::mac, s.grid, s.particles, s.order, s.m, s.u, pool_, &s.ballistic);
    s.walls.fold(s.m);
    s.walls.fold(s.u);
    to_velocity(s.m, s.u, pool_);
  });
  during(Stage::free_faces, [&] {
    extrapolate_over_air(true, s.u);
    s.walls.pad_slip(s.u);
  });
  keep_u();
}

/// u_old = u.
template <int Dim, class Real> void FluidSolver<Dim, Real>::keep_u() {
  for (std::size_t a = 0; a < Dim; ++a) {
    const Field<Real>& u = state_.u[a];
    state_.u_old[a].resize(u.size());
    pool_.ranges(state_.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      std::copy(u.data() + begin, u.data() + end, state_.u_old[a].data() + begin);
    });
  }
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::add_gravity(double dt) {
  auto& s = state_;
  during(Stage::forces, [&] {
    for (std::size_t a = 0; a < Dim; ++a) {
      const Real du = static_cast<Real>(dt * s.settings.fluid.gravity[a]);
      if (du == 0) continue;
      pool_.ranges(s.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
        Real* u = s.u[a].data();
        for (std::int64_t i = begin; i < end; ++i) u[i] += du;
      });
    }
    accelerate_ballistic(s.settings.fluid.gravity, dt, s.ballistic, s.particles, pool_);
  });
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::project(double dt, Field<double>& p) {
  auto& s = state_;
  during(Stage::walls, [&] { s.walls.close(s.u, pool_); });
  s.solids.before_projection(s.u);
  during(Stage::projection, [&] {
    s.solve = projection_(s.grid, s.walls, s.cells, s.settings.pressure, s.settings.fluid.density, dt, s.u, p, pool_);
  });
  count_solve();
  during(Stage::extrapolation, [&] {
    s.solids.carry_change(s.walls, s.cells, s.m, s.u, pool_);
    extrapolate_over_air(false, s.u);
    s.walls.close(s.u, pool_);
    s.walls.pad_slip(s.u);
  });
  if (s.walls.friction()) during(Stage::walls, [&] { s.walls.pad(s.u); });
  if (s.solids.none()) return;
  during(Stage::extrapolation, [&] {
    s.solids.constrain(s.walls, s.u, pool_);
    s.walls.pad(s.u);
  });
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::count_solve() const {
  if (!profile_) return;
  const Timed timed(profile_, Phase::outside);
  ++profile_->solves;
  profile_->iterations += static_cast<std::uint64_t>(state_.solve.iterations);
  const auto& fluid = state_.cells.fluid;
  profile_->cells += static_cast<std::uint64_t>(std::count(fluid.begin(), fluid.end(), 1));
}

/// The change of the grid a second time, and that of the particles that are not on it: blend = u_old + 2 (u - u_old).
template <int Dim, class Real> void FluidSolver<Dim, Real>::reflect(double dt) {
  auto& s = state_;
  during(Stage::second_half, [&] {
    combine(2, -1, s.u_old);
    s.walls.pad(blend_);
    accelerate_ballistic(s.settings.fluid.gravity, dt, s.ballistic, s.particles, pool_);
  });
}

template <int Dim, class Real> void FluidSolver<Dim, Real>::grid_to_particles(const Components<Dim, Real>& u) {
  auto& s = state_;
  const auto& transfer = s.settings.transfer;
  during(Stage::g2p, [&] {
    const auto fold = [&](Components<Dim, Real>& sums) { s.walls.fold(sums); };
    xpic_.gather(transfer.corner(), transfer.kernel, Layout::mac, s.grid, u, s.u_old, s.order, fold, s.particles, pool_,
                 &s.ballistic);
  });
}

/// A projection at the particles' places, handed to them as a correction: it costs no blending.
template <int Dim, class Real> void FluidSolver<Dim, Real>::remove_divergence(double dt) {
  auto& s = state_;
  const auto& transfer = s.settings.transfer;
  find_liquid();
  particles_to_grid();
  project(dt, correction_pressure_);
  const auto hand_over = [&] {
    combine(1, -1, s.u_old);
    g2p_increment(transfer.corner(), transfer.kernel, Layout::mac, s.grid, blend_, s.particles, pool_, &s.ballistic);
  };
  during(Stage::g2p, hand_over, Gather::increment);
}

template <int Dim, class Real>
void FluidSolver<Dim, Real>::combine(Real a, Real b, const Components<Dim, Real>& other) {
  for (std::size_t d = 0; d < Dim; ++d) {
    blend_[d].resize(state_.u[d].size());
    pool_.ranges(state_.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      const Real *u = state_.u[d].data(), *v = other[d].data();
      Real* out = blend_[d].data();
      for (std::int64_t i = begin; i < end; ++i) out[i] = a * u[i] + b * v[i];
    });
  }
}

/// From time t on; the obstacles follow.
template <int Dim, class Real>
void FluidSolver<Dim, Real>::advect(double dt, const Components<Dim, Real>& u, double t, FirstStage first) {
  auto& s = state_;
  during(Stage::advection, [&] {
    const bool met_wall = flipbook::advect(s.settings.time.advection, s.settings.transfer.kernel, s.grid, s.walls, u,
                                           dt, s.ballistic, s.particles, pool_, first);
    if (ledger_) ledger_->met_wall(met_wall);
    place_solids(t + dt);
  });
}

/// In a new order of the particles, where nobody knows which were ballistic: none loses velocity.
template <int Dim, class Real> void FluidSolver<Dim, Real>::keep_apart() {
  auto& s = state_;
  const double strength = s.settings.fluid.spacing;
  if (strength == 0) return;
  during(Stage::spacing, [&] {
    sort_by_cell(s.particles, s.grid, s.order, pool_);
    correct_spacing(strength, s.grid.dx / s.settings.seeding.per_axis, s.grid, s.walls, s.order, s.particles, pool_);
    s.solids.push_out(s.walls, {}, s.particles, pool_);
  });
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
  known_.resize(s.grid);
  for (std::size_t a = 0; a < Dim; ++a)
    pool_.ranges(s.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      const Real *inverse_theta = s.cells.inverse_theta[a].data(), *m = s.m[a].data();
      const std::uint8_t* buried = s.walls.buried[a].empty() ? nullptr : s.walls.buried[a].data();
      std::uint8_t* known = known_[a].data();
      if (!massless_too && !buried)
        for (std::int64_t i = begin; i < end; ++i) known[i] = inverse_theta[i] > 0;
      else
        for (std::int64_t i = begin; i < end; ++i)
          known[i] = inverse_theta[i] > 0 && ((!massless_too && !buried[i]) || m[i] > 0);
    });
  // A particle may cross cfl cells within a step, and a cubic stencil reaches two cells beyond its own.
  const int layers = 2 + std::max(1, static_cast<int>(std::ceil(s.settings.time.cfl)));
  extrapolate(s.grid, s.walls, known_, layers, u, pool_);
}

template class FluidSolver<2, float>;
template class FluidSolver<2, double>;
template class FluidSolver<3, float>;
template class FluidSolver<3, double>;

} // namespace flipbook
