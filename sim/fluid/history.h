// SPDX-License-Identifier: MIT
// What a run of the fluid says about itself at a frame: a row of curves from its ledger, and sentences.
#pragma once

#include "sim/fluid/fluid_ledger.h"
#include "sim/frame/curves.h"

#include <string>
#include <vector>

namespace flipbook {

/// The row: energies (J), momenta, what each stage has lost, and how good the step is:
///   transfer_loss           kinetic energy lost by P2G, free faces and G2P since the start
///   lost_<stage>            kinetic energy that a stage has lost since the start; negative: given
///   angular_momentum_ratio  L . L_0 / |L_0|^2; only where L is defined and L_0 is not negligible
///   momentum_drift          what the transfers have changed of the momentum
///   divergence              the largest |div u| dt in liquid after a projection, since the last row
///   settled_volume          volume of the liquid by its level set over that at the start; with a free surface only
///   front, height           how far the liquid has come on the floor, how high it is at the wall (sim/core/reach.h)
///   noise                   RMS of |v_p - u(x_p)| (m/s), where asked for: it costs a transfer
template <int Dim, class Real>
[[nodiscard]] HistoryRow history_row(const FluidState<Dim, Real>& state, FluidLedger<Dim, Real>& ledger, bool noise,
                                     Pool& pool);

/// Where the conditions of the propositions do not hold, and what else a reader must know.
template <int Dim, class Real> [[nodiscard]] std::vector<std::string> notes(const FluidState<Dim, Real>& state);

/// What went wrong so far without stopping the run.
[[nodiscard]] std::vector<std::string> warnings(const SolveReport& solve);

} // namespace flipbook
