// SPDX-License-Identifier: MIT
// Incompressible, inviscid flow of a liquid with a free surface, by particles and a MAC grid:
//   Du/Dt = -grad p / rho + g,   div u = 0,   p = 0 on the surface, u.n = U.n on walls and obstacles.
// The ways of splitting a step into equations are lie(), midpoint() and reflection() below.
#pragma once

#include "sim/fluid/advect.h"
#include "sim/fluid/extrapolate.h"
#include "sim/fluid/fluid_ledger.h"
#include "sim/fluid/fluid_state.h"
#include "sim/fluid/fluid_still.h"
#include "sim/fluid/particle_table.h"
#include "sim/fluid/project.h"
#include "sim/fluid/recorder.h"
#include "sim/fluid/stage_hook.h"
#include "sim/simulation.h"
#include "sim/transfer/xpic.h"

namespace flipbook {

template <int Dim, class Real> class FluidSolver final : public Simulation {
public:
  /// Ids of the particles must be smaller than a few times their number: seeded positions are kept by id.
  FluidSolver(const Settings& settings, Particles<Dim, Real> particles, Pool& pool,
              std::vector<Obstacle> obstacles = {}, std::unique_ptr<StageHook<Dim, Real>> hook = nullptr);

  [[nodiscard]] double time() const override { return state_.time; }
  [[nodiscard]] std::uint64_t steps() const override { return state_.steps; }
  [[nodiscard]] double max_dt() const override;
  void step(double dt) override;

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override;

  /// See interact.cpp. What changes in the particles is booked to the forces.
  [[nodiscard]] Refusal interact(const Interaction& action) override;

  [[nodiscard]] std::string title() const override { return state_.settings.transfer.title(); }
  [[nodiscard]] std::size_t particles() const override { return state_.particles.size(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override {
    const Timed timed(profile_, Phase::snapshot);
    return recorder_.snapshot(state_, ledger_ ? &*ledger_ : nullptr, frame, request, pool_);
  }
  [[nodiscard]] std::shared_ptr<const Snapshot> peek(std::uint64_t frame, const FrameRequest& request) const override {
    Recorder<Dim, Real> recorder = recorder_;
    return recorder.snapshot(state_, nullptr, frame, request, pool_);
  }
  [[nodiscard]] ParticleTable particle_table() const override {
    return flipbook::particle_table(state_.particles, state_.settings.grid.origin);
  }
  void profile(Profile* p) override { profile_ = projection_.profile = p; }
  [[nodiscard]] bool watch(StageTap* tap) override {
    tap_ = tap;
    return true;
  }

  [[nodiscard]] const FluidState<Dim, Real>& state() const { return state_; }
  /// None where ledger.on is false.
  [[nodiscard]] const std::optional<FluidLedger<Dim, Real>>& ledger() const { return ledger_; }

private:
  // === The three splittings
  void lie(double dt);
  void midpoint(double dt);
  void reflection(double dt);

  // === Their parts
  void find_liquid();
  void particles_to_grid();
  void keep_u();
  void add_gravity(double dt);
  void project(double dt, Field<double>& p);
  void reflect(double dt);
  void grid_to_particles(const Components<Dim, Real>& u);
  void remove_divergence(double dt);
  void advect(double dt, const Components<Dim, Real>& u, double t, FirstStage first = FirstStage::looked_up);
  void keep_apart();
  /// The obstacles where they are at time t, with what they caught pushed out.
  void place_solids(double t);

  /// body() as that stage: the hook acts at its borders, then the ledger looks at what has changed.
  template <class Body> void during(Stage stage, Body&& body, Gather gather = Gather::scheme);

  /// The tap looks at what a stage has left, or at the particles at the borders of a step.
  void show(Stage stage) const {
    const StillOf of{stage_names[static_cast<std::size_t>(stage)].name, state_.time, step_dt_};
    if (tap_) tap_->saw(fluid_still(of, state_, stage == Stage::second_half ? blend_ : state_.u));
  }
  void show(std::string_view border) const {
    if (tap_) tap_->saw(still_of_particles({border, state_.time, step_dt_}, state_.grid, state_.particles));
  }

  void extrapolate_over_air(bool massless_too, Components<Dim, Real>& u);
  /// blend = a u + b other.
  void combine(Real a, Real b, const Components<Dim, Real>& other);
  void gather_affine_state();
  void act(const Push& push);
  void act(const AddParticles& add);
  void act(const RemoveParticles& remove);
  void act(const MoveSolid& move);
  void count_solve() const; ///< for the profile

  Pool& pool_;
  FluidState<Dim, Real> state_;
  Projection<Dim, Real> projection_;
  Components<Dim, Real> blend_;     ///< see combine
  Known<Dim> known_;                ///< room of extrapolate_over_air
  Components<Dim, Real> u_opening_; ///< velocity at the start of a midpoint step
  XpicTerms<Dim, Real> xpic_;
  Field<double> correction_pressure_; ///< of remove_divergence
  std::optional<FluidLedger<Dim, Real>> ledger_;
  Recorder<Dim, Real> recorder_;
  std::unique_ptr<StageHook<Dim, Real>> hook_; ///< null in a normal run
  StageTap* tap_ = nullptr;                    ///< likewise
  Profile* profile_ = nullptr;                 ///< likewise
  double step_dt_ = 0;                         ///< of the step that is being taken
};

} // namespace flipbook
