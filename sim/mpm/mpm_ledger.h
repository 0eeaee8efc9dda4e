// SPDX-License-Identifier: MIT
// The ledger of a run of the material point method: what is held after each stage of a step, and so what the stage
// changed.
//
// Between two steps the particles hold mass, momentum, angular momentum, kinetic and potential energy; from P2G to G2P
// the grid holds all but the last, on the masses of that P2G (sim/diagnostics/ledger.h, on nodes). Potential energy is
// -sum m g . x, elastic energy sum V0 Psi: only the motion changes them, and plastic flow the latter. So `stress` shows
// what elastic energy gave to the kinetic one, and `motion` what it got: the two agree to the order of dt.
//
// Claims are tried in every step:
//   everywhere  mass: no change
//   P2G         momentum, angular momentum: no change; kinetic energy: no rise; every scheme, all modes counted
//   stress      momentum, angular momentum: no change
//   contact     kinetic energy: no rise, unless an obstacle moves
//   G2P         momentum: no change; angular momentum: no change for RPIC, APIC, PolyPIC; kinetic energy: no rise for
//               these and PIC
//   motion      angular momentum: no change where x += dt v_p, nothing met a wall, no obstacle is there, and no D_p
//               went with the place (the linear kernel's does)
//   flow        elastic energy: no rise, where no material stiffens or hardens as it flows
// P2G, G2P and motion: the propositions of the tech report of APIC.
//
// Stress. The forces are f_i = -sum_p V0 tau h_ip with h_ip = grad w_ip, or with MLS h_ip = w_ip D_p^-1 (x_i - x_p).
// Every kernel reproduces linear functions, sum_i w_ip = 1 and sum_i w_ip x_i = x_p at any x_p; the gradients of these
// by x_p are sum_i grad w_ip = 0 and sum_i x_i (grad w_ip)^T = I. MLS has the same: sum_i w_ip (x_i - x_p) = 0, and
// sum_i x_i (h_ip)^T = sum_i w_ip (x_i - x_p) (x_i - x_p)^T D_p^-1 = I. (On the linear kernel, whose weights are
// linear between two nodes, both h_ip are one.) So for each particle
//   sum_i f_i = 0,   (sum_i x_i x f_i)_c = -V0 sum_ab e_cab (tau sum_i h_ip x_i^T)_ba = -V0 sum_ab e_cab tau_ba = 0
// because tau is symmetric. Only nodes without mass can break it, on which forces cannot act: a linear kernel's
// gradient does not vanish on a node that the particle gives nothing to, when it lies on the faces of a cell.
//
// Flow. Where it shortens the deviator of Hencky's strains, or takes back strain altogether, the energy falls, whatever
// happens to the yield surface (sand, von Mises); so it does where a liquid cavitates. Snow is another matter, and
// nothing is claimed of it (flow_only_takes of the materials): clamped singular values may be farther from det F = 1
// than before, in 3D one on its upper and two on their lower limit, and what is compacted is stiffer by e^(xi (1 -
// J_P)).
//
// "No change" is at most 50 eps of what the sum could be with the kinetic energy of the step, sum m |v| <= sqrt(2 m T);
// of mass and energy themselves. Forces add to that what they sum up: dt sum_i |f_i| is at most 2 Dim^(3/2) (c dt / dx)
// sqrt(2 m W) for the elastic energy W and the speed c of waves, for small strains have |tau|^2 <= 2 Dim rho_0 c^2 Psi,
// and sum_i |h_ip| is at most 2 Dim / dx. Elastic energy is known to what the rounding of F makes of it, some eps
// sqrt(2 W m c^2), and to eps m c^2, for some materials give it as a small difference of terms of that size.
#pragma once

#include "sim/diagnostics/account.h"
#include "sim/diagnostics/ledger.h"
#include "sim/mpm/mpm_stage.h"
#include "sim/mpm/mpm_state.h"

#include <array>
#include <optional>

namespace flipbook {

template <int Dim, class Real> class MpmLedger {
public:
  /// Opens with what the particles hold; state.totals must be theirs.
  MpmLedger(const MpmState<Dim, Real>& state, Pool& pool);

  void begin_step(double dt);
  /// After a stage. `u`: the velocity on the grid, which holds it up to G2P. After motion and flow state.totals must be
  /// new.
  void left(MpmStage stage, const MpmState<Dim, Real>& state, const Components<Dim, Real>& u, Pool& pool);
  void end_step(const MpmState<Dim, Real>& state);
  /// Between steps, after parameters have changed what is held: books that to a stage without any claim. What elastic
  /// energy came of it the run may spend.
  void rebook(MpmStage stage, const MpmState<Dim, Real>& state, Pool& pool);

  // === Looking at it
  /// Where a quantity stands in a row.
  static constexpr std::size_t mass = 0, momentum = 1, angular_momentum = 1 + Dim,
                               kinetic = angular_momentum + static_cast<std::size_t>(spin<Dim>),
                               potential = kinetic + 1, elastic = potential + 1, quantities = elastic + 1;
  [[nodiscard]] double held(std::size_t quantity) const { return account_.held()[quantity]; }
  [[nodiscard]] double start(std::size_t quantity) const { return start_[quantity]; }
  [[nodiscard]] double total(MpmStage stage, std::size_t quantity) const {
    return account_.total(static_cast<std::size_t>(stage), quantity);
  }
  [[nodiscard]] double in_step(MpmStage stage, std::size_t quantity) const {
    return account_.in_step(static_cast<std::size_t>(stage), quantity);
  }
  /// Kinetic energy that the transfers have lost so far (J).
  [[nodiscard]] double transfer_loss() const;
  /// |P - P_0 - what gravity, walls and obstacles gave|: what the transfers and the forces of the stress changed of the
  /// momentum (kg m/s).
  [[nodiscard]] double momentum_drift() const;
  /// L . L_0 / |L_0|^2, where L is defined and L_0 is not negligible.
  [[nodiscard]] std::optional<double> spin_ratio() const;
  [[nodiscard]] bool spin_defined() const;
  /// Kinetic and elastic energy over that of the start, where no force has acted and the start is more than 50 eps m
  /// c^2, within which rounding would show.
  [[nodiscard]] std::optional<double> energy_ratio(const Settings& settings) const;
  /// Can the stage change anything in this run? (Nothing falls without gravity; a periodic domain without obstacles has
  /// no contact; elastic materials do not flow.)
  [[nodiscard]] bool can_have(MpmStage stage, const Settings& settings) const;
  /// The table, with the accounts since the last call.
  [[nodiscard]] LedgerTable publish(const Settings& settings);

private:
  using Numbers = std::array<double, quantities>;
  [[nodiscard]] Numbers row(const Totals<Dim>& totals, double potential_energy, double elastic_energy) const;
  [[nodiscard]] Numbers on_particles(const MpmState<Dim, Real>& state, double elastic_energy, Pool& pool) const;
  [[nodiscard]] Numbers measured(MpmStage stage, const MpmState<Dim, Real>& state, const Components<Dim, Real>& u,
                                 Pool& pool) const;
  void look_at_materials(const MpmState<Dim, Real>& state);
  void book(MpmStage stage, const Numbers& now);

  void judge(MpmStage stage, const MpmState<Dim, Real>& state);
  void judge_gather(const Corner& corner, KernelName kernel);
  void judge_motion(const MpmState<Dim, Real>& state);
  void judge_flow(const MpmState<Dim, Real>& state);
  /// No change beyond the rounding of a sum of momenta that are `most` if nothing in it cancels.
  void claim_momentum(MpmStage stage, double most);
  void claim_spin(MpmStage stage, double most);
  void claim_no_rise(MpmStage stage);
  /// sum m |v| is at most this in the step.
  [[nodiscard]] double momenta() const;
  void count_given(bool solids_move);

  Vec<Dim, double> origin_;
  std::array<bool, static_cast<std::size_t>(Dim)> periodic_{};
  bool confined_;                ///< are there walls or obstacles?
  bool flows_ = false;           ///< does any material?
  bool flow_only_takes_ = false; ///< and none of those that do may gain elastic energy by it
  double reach_;                 ///< how far the domain reaches from the origin (m)
  double dx_;
  Numbers start_{};
  Numbers change_{}; ///< what was booked last
  Stretches<Dim, Real> stretches_;
  double kinetic_before_ = 0, elastic_before_ = 0, kinetic_most_ = 0; ///< when the step began, and since
  double given_ = 0, energy_in_ = 0;
  double dt_ = 0;
  double wave_energy_ = 0;                           ///< m c^2 at the start, with the fastest wave
  std::array<bool, mpm_stage_names.size()> acted_{}; ///< has ever changed anything
  Account account_;
};

} // namespace flipbook
