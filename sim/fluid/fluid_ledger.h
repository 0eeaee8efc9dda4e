// SPDX-License-Identifier: MIT
// The ledger of a run of the fluid: what is held after each stage of a step, and so what the stage changed.
//
// Between two steps the particles hold it all. From P2G to G2P the grid does, on the face masses of that P2G, with the
// ballistic particles beside it, which take no part in a transfer:
//   held = sum_a sum_i m_ai (1, u_ai, x_ai x e_a u_ai, u_ai^2 / 2) + the same of the ballistic particles
// (sim/diagnostics/ledger.h). Potential energy is the particles', -sum m g . x: only what moves them changes it.
//
// Claims are what the propositions of the tech report of APIC say of a stage, tried in every step:
//   P2G        momentum, angular momentum: no change; kinetic energy: no rise; every scheme, all modes counted
//   G2P        momentum: no change, but that FLIP's share gives back what the stage "free faces" took; angular
//              momentum: no change for RPIC, APIC, PolyPIC; kinetic energy: no rise for these and PIC
//   advection  angular momentum: no change where x += dt v_p, nothing met a wall, and no D_p went with the place
//   everywhere mass: no change
// "No change" is at most 50 eps of what the sum could be with the kinetic energy of the step, sum m |v| <= sqrt(2 m T);
// of mass and energy themselves. A weight, a product and its place in a sum round to a few eps each, and mostly cancel:
// over all schemes, kernels and dimensions at most 1 eps was measured in single, 5 in double, where the ledger's own
// sums round as much.
#pragma once

#include "sim/diagnostics/account.h"
#include "sim/diagnostics/ledger.h"
#include "sim/fluid/fluid_state.h"
#include "sim/fluid/stage.h"

#include <array>
#include <optional>

namespace flipbook {

/// Which of two transfers to the particles a G2P was.
enum class Gather { scheme, increment };

template <int Dim, class Real> class FluidLedger {
public:
  /// Opens with what the particles hold; the level set must be theirs.
  FluidLedger(const FluidState<Dim, Real>& state, Pool& pool);

  void begin_step(double dt);
  /// After a stage. `u`: the velocity on the grid, which holds it up to G2P.
  void left(Stage stage, const FluidState<Dim, Real>& state, const Components<Dim, Real>& u, Gather gather, Pool& pool);
  /// After advection and before left(): whether a particle met a wall.
  void met_wall(bool met) { met_wall_ = met_wall_ || met; }
  void end_step(const FluidState<Dim, Real>& state);
  /// Between steps, after parameters have changed what the particles hold: books that to a stage without any claim.
  void rebook(Stage stage, const FluidState<Dim, Real>& state, Pool& pool);

  // === Looking at it
  /// Where a quantity stands in a row.
  static constexpr std::size_t mass = 0, momentum = 1, angular_momentum = 1 + Dim,
                               kinetic = angular_momentum + static_cast<std::size_t>(spin<Dim>),
                               potential = kinetic + 1, quantities = potential + 1;
  [[nodiscard]] double held(std::size_t quantity) const { return account_.held()[quantity]; }
  [[nodiscard]] double start(std::size_t quantity) const { return start_[quantity]; }
  [[nodiscard]] double total(Stage stage, std::size_t quantity) const {
    return account_.total(static_cast<std::size_t>(stage), quantity);
  }
  [[nodiscard]] double in_step(Stage stage, std::size_t quantity) const {
    return account_.in_step(static_cast<std::size_t>(stage), quantity);
  }
  /// Kinetic energy that the transfers have lost so far (J).
  [[nodiscard]] double transfer_loss() const;
  /// |P - P_0 - what forces, walls, pressure and obstacles gave|: what the transfers changed of the momentum (kg m/s).
  [[nodiscard]] double momentum_drift() const;
  /// L . L_0 / |L_0|^2, where L is defined and L_0 is not negligible.
  [[nodiscard]] std::optional<double> spin_ratio() const;
  [[nodiscard]] bool spin_defined() const;
  /// Volume of the liquid when the run began (m^3; m^2 in 2D).
  [[nodiscard]] double start_volume() const { return start_volume_; }
  /// Can the stage change anything in this run? (Nothing falls without gravity; where no side and no obstacle bounds a
  /// liquid that fills the domain, walls have nothing to take and every face touches liquid.)
  [[nodiscard]] bool can_have(Stage stage, const Settings& settings) const;
  /// The largest |div u| dt of a liquid cell after a projection since the last call.
  [[nodiscard]] double take_divergence();
  /// The table, with the accounts since the last call.
  [[nodiscard]] LedgerTable publish(const Settings& settings);

private:
  using Numbers = std::array<double, quantities>;
  [[nodiscard]] Numbers row(const Totals<Dim>& totals, double potential_energy) const;
  [[nodiscard]] Numbers on_particles(const FluidState<Dim, Real>& state, Pool& pool) const;
  [[nodiscard]] Numbers on_grid(const FluidState<Dim, Real>& state, const Components<Dim, Real>& u, Pool& pool) const;
  [[nodiscard]] Totals<Dim> totals(const FluidState<Dim, Real>& state, const std::vector<std::uint8_t>* only,
                                   Pool& pool) const;
  void book(Stage stage, const Numbers& now);

  void judge(Stage stage, const FluidState<Dim, Real>& state, Gather gather);
  void judge_gather(const FluidState<Dim, Real>& state, Gather gather);
  void judge_advection(const FluidState<Dim, Real>& state);
  /// No change: change_ + back freed_ is nothing but rounding.
  void claim_momentum(Stage stage, double back = 0);
  void claim_spin(Stage stage, double back = 0);
  void claim_no_rise(Stage stage);
  void count_given(bool solids_move);

  Vec<Dim, double> origin_;
  std::array<bool, static_cast<std::size_t>(Dim)> periodic_{};
  bool confined_; ///< are there walls or obstacles?
  double reach_;  ///< how far the domain reaches from the origin (m)
  double start_volume_;
  Numbers start_{};
  Numbers change_{}; ///< what was booked last
  Numbers freed_{};  ///< and to free_faces
  Totals<Dim> ballistic_;
  Stretches<Dim, Real> stretches_;
  double kinetic_before_ = 0, kinetic_most_ = 0; ///< when the step began, and since
  double given_ = 0, energy_in_ = 0;
  double dt_ = 0, divergence_ = 0;
  bool met_wall_ = false;
  std::array<bool, stage_names.size()> acted_{}; ///< has ever changed anything
  Account account_;
};

} // namespace flipbook
