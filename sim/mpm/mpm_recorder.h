// SPDX-License-Identifier: MIT
// What a run of the material point method publishes: a snapshot for each frame, with the extremes and the curves of all
// frames so far. The curves:
//   kinetic, potential, elastic, total  energies (J)
//   energy_ratio            kinetic and elastic energy over that of the start; only without gravity
//   transfer_loss           kinetic energy lost by P2G and G2P since the start
//   lost_<stage>            kinetic energy that a stage has lost since the start; negative: given. Not of flow, which
//                           takes elastic energy alone
//   momentum_.., angular_momentum_..
//   angular_momentum_ratio  L . L_0 / |L_0|^2; only where L is defined and L_0 is not negligible
//   momentum_drift          what the transfers and the forces of the stress have changed of the momentum
//   noise                   RMS of |v_p - u(x_p)| (m/s), where asked for: it costs a transfer
#pragma once

#include "sim/fluid/solid_surfaces.h"
#include "sim/frame/curves.h"
#include "sim/frame/trails.h"
#include "sim/mpm/mpm_channels.h"
#include "sim/mpm/mpm_ledger.h"

#include <memory>
#include <string>
#include <vector>

namespace flipbook {

template <int Dim, class Real> class MpmRecorder {
public:
  /// Remembers where each particle starts, by id: ids must be smaller than a few times their number.
  MpmRecorder(const MpmState<Dim, Real>& start, Pool& pool);

  /// Remembers where particles start that have come in since; they have no spokes.
  void follow(const Particles<Dim, Real>& particles);
  /// An id that no particle ever had.
  [[nodiscard]] std::uint32_t next_id() const { return static_cast<std::uint32_t>(start_.x.size()); }

  /// Without a ledger there are no curves either.
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(const MpmState<Dim, Real>& state, MpmLedger<Dim, Real>* ledger,
                                                         std::uint64_t frame, const FrameRequest& request, Pool& pool);

private:
  [[nodiscard]] Channel channel(const MpmState<Dim, Real>& state, const std::string& name, Pool& pool);

  MpmStart start_;
  ChannelRanges ranges_;
  History history_;
  Trails trails_;
  SolidSurfaces surfaces_;
};

/// Where the conditions of the propositions do not hold, and what else a reader must know.
template <int Dim, class Real> [[nodiscard]] std::vector<std::string> notes(const MpmState<Dim, Real>& state);

/// What the settings do to the run that nobody wants.
template <int Dim, class Real> [[nodiscard]] std::vector<std::string> warnings(const MpmState<Dim, Real>& state);

} // namespace flipbook
