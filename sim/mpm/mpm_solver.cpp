// SPDX-License-Identifier: MIT
#include "sim/mpm/mpm_solver.h"

#include "sim/core/check_finite.h"
#include "sim/fluid/box.h"
#include "sim/fluid/largest.h"
#include "sim/mpm/contact.h"
#include "sim/mpm/motion.h"
#include "sim/mpm/seed_solids.h"
#include "sim/mpm/stress.h"
#include "sim/transfer/transfer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook {
namespace {

constexpr std::int64_t samples_per_chunk = 1 << 14;

} // namespace

// === Setting up

template <int Dim, class Real>
MpmSolver<Dim, Real>::MpmSolver(const Scene& scene, Pool& pool)
    : pool_(pool), state_(seed_solids<Dim, Real>(scene, pool)), recorder_(state_, pool) {
  auto& s = state_;
  check_finite(
      s.particles, [&] { return title(); }, 0, 0, pool_);
  s.solids.place(0, s.walls, pool_);
  s.particles.set_mode(s.settings.transfer.corner().mode);
  f_.resize(s.grid);
  ask();
  particles_to_grid();
  gather_affine_state();
  if (s.settings.ledger.on) ledger_.emplace(s, pool_);
}

template <int Dim, class Real> std::vector<Parameter> MpmSolver<Dim, Real>::parameters() const {
  Settings settings = state_.settings;
  return parameters_of(settings);
}

template <int Dim, class Real> Refusal MpmSolver<Dim, Real>::set(std::string_view path, const Value& value) {
  auto& s = state_;
  for (const Parameter& p : parameters())
    if (p.path == path && p.effect == Effect::restart) return {p.path + " cannot change during a run", ""};
  Settings next = s.settings;
  if (Refusal r = set_parameter(next, path, value); !r.message.empty()) return r;
  if (const auto conflict = next.conflict(); !conflict.message.empty()) return {conflict.message, ""};
  const TransferSettings before = std::exchange(s.settings, next).transfer;
  if (path.starts_with("material.")) {
    s.materials[0] = next.material;
    ask();
    if (ledger_) ledger_->rebook(MpmStage::stress, s, pool_);
  }
  if (next.transfer.corner().mode != before.corner().mode || next.transfer.kernel != before.kernel) {
    gather_affine_state();
    if (ledger_) ledger_->rebook(MpmStage::g2p, s, pool_);
  } else if (ledger_ && path == "fluid.gravity") {
    ledger_->rebook(MpmStage::forces, s, pool_); // another potential
  }
  return {};
}

/// Particles that remember more than before find it in the velocity of the grid.
template <int Dim, class Real> void MpmSolver<Dim, Real>::gather_affine_state() {
  auto& s = state_;
  const Corner corner = s.settings.transfer.corner();
  s.particles.set_mode(corner.mode);
  gather_affine(corner, s.kernel(), Layout::nodes, s.grid, s.u, s.particles, pool_);
}

template <int Dim, class Real> double MpmSolver<Dim, Real>::max_dt() const {
  const auto& s = state_;
  const auto count = static_cast<std::int64_t>(s.particles.size());
  const Largest<Real> square = pool_.sum(count, 8192, Largest<Real>{}, [&](std::int64_t begin, std::int64_t end) {
    return largest<Real>(begin, end, [&](std::size_t p) {
      Real sum = 0;
      for (std::size_t d = Dim; d-- > 0;) sum += s.particles.v[d][p] * s.particles.v[d][p];
      return sum;
    });
  });
  const double speed = s.totals.wave_speed + std::sqrt(static_cast<double>(square.value)), cfl = s.settings.time.cfl;
  const double dt = cfl * s.grid.dx / std::max(speed, 1e-30), bound = s.settings.time.dt;
  return s.solids.max_dt(s.time, cfl, bound > 0 ? std::min(bound, dt) : dt, s.walls);
}

// === The step

template <int Dim, class Real> void MpmSolver<Dim, Real>::step(double dt) {
  auto& s = state_;
  step_t_ = s.time;
  step_dt_ = dt;
  show(StageStill::start);
  if (ledger_) ledger_->begin_step(dt);
  s.solids.give_velocity(s.time, s.time + dt, s.walls, pool_);
  particles_to_grid(); // u_i = sum_p w m (v_p + A_p (x_i - x_p)) / m_i,  u_old = u
  add_gravity(dt);     // u <- u + dt g
  add_stress(dt);      // u_i <- u_i + dt f_i / m_i,  f_i = - sum_p V0 tau grad w
  meet_solids();       // u = U, u.n = U.n, or Coulomb
  grid_to_particles(); // v, A by the scheme
  s.time += dt;
  s.last_dt = dt;
  ++s.steps;
  move(dt); // x <- x + dt sum_i w u,  F <- (I + dt sum_i u grad w^T) F
  ask();    // plastic flow, tau, Psi
  show(MpmStage::motion);
  show(StageStill::end);
  const Timed timed(profile_, Phase::ledger);
  if (ledger_) {
    ledger_->left(MpmStage::motion, s, s.u, pool_);
    ledger_->left(MpmStage::flow, s, s.u, pool_);
    ledger_->end_step(s);
  }
}

template <int Dim, class Real>
template <class Body>
void MpmSolver<Dim, Real>::during(MpmStage stage, Phase phase, Body&& body) {
  Timed timed(profile_, phase);
  body();
  show(stage);
  timed.turn(Phase::ledger);
  if (ledger_) ledger_->left(stage, state_, state_.u, pool_);
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::show(MpmStage stage) const {
  if (tap_) tap_->saw(mpm_still({mpm_stage_names[static_cast<std::size_t>(stage)].name, step_t_, step_dt_}, state_));
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::show(std::string_view border) const {
  if (tap_) tap_->saw(still_of_particles({border, step_t_, step_dt_}, state_.grid, state_.particles));
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::particles_to_grid() {
  auto& s = state_;
  during(MpmStage::p2g, Phase::p2g, [&] {
    p2g(s.settings.transfer.corner(), s.kernel(), Layout::nodes, s.grid, s.particles, s.order, s.m, s.u, pool_);
    s.walls.fold(s.m);
    s.walls.fold(s.u);
    to_velocity(s.m, s.u, pool_);
  });
  for (std::size_t a = 0; a < Dim; ++a)
    pool_.ranges(s.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      std::copy(s.u[a].begin() + begin, s.u[a].begin() + end, s.u_old[a].begin() + begin);
    });
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::add_gravity(double dt) {
  auto& s = state_;
  during(MpmStage::forces, Phase::forces, [&] {
    for (std::size_t a = 0; a < Dim; ++a) {
      const Real du = static_cast<Real>(dt * s.settings.fluid.gravity[a]);
      if (du == 0) continue;
      pool_.ranges(s.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
        Real* u = s.u[a].data();
        for (std::int64_t i = begin; i < end; ++i) u[i] += du;
      });
    }
    if (body_force_) add_body_force(dt);
  });
}

/// Through the particles, u_i <- u_i + dt sum_p w m b(x_p) / m_i, as the stress that it is to balance: a node beside a
/// free surface has less of both.
template <int Dim, class Real> void MpmSolver<Dim, Real>::add_body_force(double dt) {
  auto& s = state_;
  auto b = s.particles.v;
  pool_.ranges(static_cast<std::int64_t>(s.particles.size()), samples_per_chunk,
               [&](std::int64_t begin, std::int64_t end) {
                 for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
                   const Vec<Dim, double> x = s.particles.position(p).template cast<double>();
                   const Vec<Dim, double> now = body_force_(x, s.time);
                   for (std::size_t d = 0; d < Dim; ++d) b[d][p] = static_cast<Real>(now[static_cast<int>(d)]);
                 }
               });
  Components<Dim, Real> m = s.m;
  const AffineMode mode = std::exchange(s.particles.mode, AffineMode::none);
  s.particles.v.swap(b);
  p2g(Corner{}, s.kernel(), Layout::nodes, s.grid, s.particles, s.order, m, f_, pool_);
  s.particles.v.swap(b);
  s.particles.mode = mode;
  s.walls.fold(m);
  s.walls.fold(f_);
  to_velocity(m, f_, pool_);
  for (std::size_t a = 0; a < Dim; ++a)
    for (std::size_t i = 0; i < s.u[a].size(); ++i) s.u[a][i] += static_cast<Real>(dt) * f_[a][i];
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::add_stress(double dt) {
  auto& s = state_;
  during(MpmStage::stress, Phase::stress, [&] {
    StressColumns<Dim, Real> stress;
    for (std::size_t c = 0; c < stress.size(); ++c) stress[c] = s.particles.carried[Carried<Dim>::tau + c].data();
    scatter_stress(through(), s.kernel(), Layout::nodes, s.grid, s.particles, stress, s.order, f_, pool_);
    s.walls.fold(f_);
    const Real step = static_cast<Real>(dt);
    for (std::size_t a = 0; a < Dim; ++a)
      pool_.ranges(s.grid.size(), samples_per_chunk, [&](std::int64_t begin, std::int64_t end) {
        const Real *f = f_[a].data(), *m = s.m[a].data();
        Real* u = s.u[a].data();
        for (std::int64_t i = begin; i < end; ++i) u[i] += m[i] > 0 ? step * f[i] / m[i] : Real(0);
      });
  });
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::meet_solids() {
  during(MpmStage::contact, Phase::forces, [&] { apply_contact(state_, pool_); });
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::grid_to_particles() {
  auto& s = state_;
  during(MpmStage::g2p, Phase::g2p, [&] {
    const auto fold = [&](Components<Dim, Real>& sums) { s.walls.fold(sums); };
    xpic_.gather(s.settings.transfer.corner(), s.kernel(), Layout::nodes, s.grid, s.u, s.u_old, s.order, fold,
                 s.particles, pool_);
  });
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::move(double dt) {
  auto& s = state_;
  Timed timed(profile_, Phase::advect);
  s.met_wall = move_and_deform(s.settings.transfer.corner(), through(), s.kernel(), s.grid, s.walls, s.u, dt,
                               s.particles, pool_);
  check_finite(
      s.particles, [&] { return title(); }, s.steps, s.time, pool_);
  s.solids.place(s.time, s.walls, pool_);
  s.solids.push_out(s.walls, {}, s.particles, pool_);
  timed.turn(Phase::sort);
  // ask() writes the stress anew, and what does not flow remembers nothing.
  const bool remembers = std::any_of(s.materials.begin(), s.materials.end(), [](auto& m) { return m.flows(); });
  sort_by_cell(s.particles, s.grid, s.order, pool_, remembers ? Carried<Dim>::tau : Carried<Dim>::memory);
  follow_order(s, pool_);
}

template <int Dim, class Real> void MpmSolver<Dim, Real>::ask() {
  const Timed timed(profile_, Phase::stress);
  state_.totals = ask_materials(state_, pool_);
}

template class MpmSolver<2, float>;
template class MpmSolver<2, double>;
template class MpmSolver<3, float>;
template class MpmSolver<3, double>;

} // namespace flipbook
