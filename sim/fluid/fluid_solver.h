// SPDX-License-Identifier: MIT
// Incompressible, inviscid flow of a liquid with a free surface, by particles and a MAC grid:
//   Du/Dt = -grad p / rho + g,   div u = 0,   p = 0 on the surface, u.n = U.n on walls and obstacles.
// The two ways of splitting a step into equations are lie() and midpoint() below.
#pragma once

#include "sim/fluid/extrapolate.h"
#include "sim/fluid/fluid_state.h"
#include "sim/fluid/particle_table.h"
#include "sim/fluid/project.h"
#include "sim/fluid/recorder.h"
#include "sim/simulation.h"

namespace flipbook {

template <int Dim, class Real> class FluidSolver final : public Simulation {
public:
  /// Ids of the particles must be smaller than a few times their number: seeded positions are kept by id.
  FluidSolver(const Settings& settings, Particles<Dim, Real> particles, Pool& pool,
              std::vector<Obstacle> obstacles = {});

  [[nodiscard]] double time() const override { return state_.time; }
  [[nodiscard]] std::uint64_t steps() const override { return state_.steps; }
  [[nodiscard]] double max_dt() const override;
  void step(double dt) override;

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override;

  [[nodiscard]] std::string title() const override { return state_.settings.transfer.title(); }
  [[nodiscard]] std::size_t particles() const override { return state_.particles.size(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override {
    return recorder_.snapshot(state_, transfer_loss_, frame, request, pool_);
  }
  [[nodiscard]] ParticleTable particle_table() const override {
    return flipbook::particle_table(state_.particles, state_.settings.grid.origin);
  }

  [[nodiscard]] const FluidState<Dim, Real>& state() const { return state_; }
  /// Kinetic energy that the transfers have lost so far (J); 0 where the ledger is off.
  [[nodiscard]] double transfer_loss() const { return transfer_loss_; }

private:
  // === The two splittings
  void lie(double dt);
  void midpoint(double dt);

  // === Their parts
  void find_liquid();
  void particles_to_grid();
  void add_gravity(double dt);
  void project(double dt, Field<double>& p);
  void grid_to_particles(double dt, const Components<Dim, Real>& u);
  void gather_filtered(const Corner& corner, const Components<Dim, Real>& u);
  void correct_particles();
  void advect(double dt, const Components<Dim, Real>& u);
  void keep_apart();
  /// The obstacles where they are at time t, with what they caught pushed out.
  void place_solids(double t);

  void extrapolate_over_air(bool massless_too, Components<Dim, Real>& u);
  /// blend = a u + b other.
  void combine(Real a, Real b, const Components<Dim, Real>& other);
  template <class Transfer> void measured(const Components<Dim, Real>& u, Transfer&& transfer);
  void gather_affine_state();
  void check_finite() const;

  Pool& pool_;
  FluidState<Dim, Real> state_;
  Projection<Dim, Real> projection_;
  Components<Dim, Real> blend_;     ///< see combine
  Components<Dim, Real> u_opening_; ///< velocity at the start of a midpoint step
  XpicTerms<Dim, Real> xpic_;
  Components<Dim, Real> energies_;    ///< room for the ledger
  Field<double> correction_pressure_; ///< of the projection that opens a midpoint step
  double kinetic_before_ = 0, transfer_loss_ = 0;
  Recorder<Dim, Real> recorder_;
};

} // namespace flipbook
