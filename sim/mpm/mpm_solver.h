// SPDX-License-Identifier: MIT
// Solids and granular matter by the material point method [Sulsky, Chen, Schreyer 1994; Jiang et al. 2016]:
//   rho Du/Dt = div sigma + rho g,   sigma = tau / J,   tau = (dPsi/dF) F^T
// with particles that carry mass, deformation gradient and what their material remembers, and a grid of nodes that is
// made anew in every step. Symplectic Euler: forces from the deformation at the start of the step, motion along the
// velocity at its end.
#pragma once

#include "sim/fluid/particle_table.h"
#include "sim/mpm/mpm_ledger.h"
#include "sim/mpm/mpm_recorder.h"
#include "sim/mpm/mpm_stage.h"
#include "sim/mpm/mpm_state.h"
#include "sim/mpm/mpm_still.h"
#include "sim/simulation.h"
#include "sim/transfer/scatter_stress.h"
#include "sim/transfer/xpic.h"

#include <functional>
#include <optional>

namespace flipbook {

struct Scene;

template <int Dim, class Real> class MpmSolver final : public Simulation {
public:
  /// Throws UserError where the scene's particles are none or too many, or of more than 255 materials.
  MpmSolver(const Scene& scene, Pool& pool);

  [[nodiscard]] double time() const override { return state_.time; }
  [[nodiscard]] std::uint64_t steps() const override { return state_.steps; }
  /// time.cfl dx / (c + max |v_p|), with c the speed of the fastest wave in any of the materials as they are now; and
  /// what moving obstacles allow.
  [[nodiscard]] double max_dt() const override;
  /// Throws InvertedError, too: see stress.h.
  void step(double dt) override;

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  /// Parameters of the scene's own material may change in mid-run: its particles keep their deformation.
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override;

  /// See interact.cpp. Added particles are of the material that is nearest. What changes in the particles is booked to
  /// the forces.
  [[nodiscard]] Refusal interact(const Interaction& action) override;

  [[nodiscard]] std::string title() const override { return state_.settings.transfer.title(); }
  [[nodiscard]] std::size_t particles() const override { return state_.particles.size(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override {
    const Timed timed(profile_, Phase::snapshot);
    return recorder_.snapshot(state_, ledger_ ? &*ledger_ : nullptr, frame, request, pool_);
  }
  [[nodiscard]] std::shared_ptr<const Snapshot> peek(std::uint64_t frame, const FrameRequest& request) const override {
    MpmRecorder<Dim, Real> recorder = recorder_;
    return recorder.snapshot(state_, nullptr, frame, request, pool_);
  }
  [[nodiscard]] ParticleTable particle_table() const override {
    return flipbook::particle_table(state_.particles, state_.settings.grid.origin, Carried<Dim>::names());
  }
  void profile(Profile* p) override { profile_ = p; }
  [[nodiscard]] bool watch(StageTap* tap) override {
    tap_ = tap;
    return true;
  }

  /// An acceleration (m/s^2) of the particles on top of gravity, at a place (metres from the lower corner of the
  /// domain) and a time: for manufactured solutions. The ledger books it with gravity.
  using BodyForce = std::function<Vec<Dim, double>(const Vec<Dim, double>& x, double t)>;
  void body_force(BodyForce force) { body_force_ = std::move(force); }

  [[nodiscard]] const MpmState<Dim, Real>& state() const { return state_; }
  /// None where ledger.on is false.
  [[nodiscard]] const std::optional<MpmLedger<Dim, Real>>& ledger() const { return ledger_; }

private:
  // === The parts of a step
  void particles_to_grid();
  void add_gravity(double dt);
  void add_body_force(double dt);
  void add_stress(double dt);
  void meet_solids();
  void grid_to_particles();
  void move(double dt);
  void ask();

  /// body() as that stage; then the ledger looks at what has changed.
  template <class Body> void during(MpmStage stage, Phase phase, Body&& body);
  void show(MpmStage stage) const;          ///< to the tap: what a stage has left
  void show(std::string_view border) const; ///< and the particles at the borders of a step
  void gather_affine_state();
  void act(const Push& push);
  void act(const AddParticles& add);
  void act(const RemoveParticles& remove);
  void act(const MoveSolid& move);
  void follow_particles(); ///< after some have come or gone
  [[nodiscard]] Through through() const {
    return state_.settings.mpm.forces == Forces::mls ? Through::affine : Through::gradient;
  }

  Pool& pool_;
  MpmState<Dim, Real> state_;
  Components<Dim, Real> f_; ///< forces of the stress (N)
  XpicTerms<Dim, Real> xpic_;
  BodyForce body_force_; ///< empty: none
  std::optional<MpmLedger<Dim, Real>> ledger_;
  MpmRecorder<Dim, Real> recorder_;
  Profile* profile_ = nullptr;
  StageTap* tap_ = nullptr;         ///< null in a normal run
  double step_t_ = 0, step_dt_ = 0; ///< of the step that is being taken: its start and its length
};

} // namespace flipbook
