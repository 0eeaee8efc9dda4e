// SPDX-License-Identifier: MIT
#include "sim/fluid/history.h"

#include "sim/fluid/channels.h"
#include "sim/fluid/liquid_volume.h"
#include "sim/fluid/publish.h"
#include "sim/fluid/reach_row.h"

#include <cmath>

namespace flipbook {

template <int Dim, class Real>
HistoryRow history_row(const FluidState<Dim, Real>& s, FluidLedger<Dim, Real>& ledger, bool noise, Pool& pool) {
  using Ledger = FluidLedger<Dim, Real>;
  const std::string per = Dim == 2 ? "/m" : "", joule = "J" + per;
  HistoryRow row;
  const double kinetic = ledger.held(Ledger::kinetic), potential = ledger.held(Ledger::potential);
  row.add("kinetic", joule, kinetic);
  row.add("potential", joule, potential);
  row.add("total", joule, kinetic + potential);
  row.add("transfer_loss", joule, ledger.transfer_loss());
  for (int a = 0; a < Dim; ++a)
    row.add(std::string("momentum_") + "xyz"[a], "kg m/s" + per,
            ledger.held(Ledger::momentum + static_cast<std::size_t>(a)));
  for (int c = 0; c < spin<Dim>; ++c)
    row.add(std::string("angular_momentum_") + "xyz"[Dim == 2 ? 2 : c], "kg m^2/s" + per,
            ledger.held(Ledger::angular_momentum + static_cast<std::size_t>(c)));
  if (const auto ratio = ledger.spin_ratio()) row.add("angular_momentum_ratio", "", *ratio);
  row.add("momentum_drift", "kg m/s" + per, ledger.momentum_drift());
  row.add("divergence", "", ledger.take_divergence());
  if (s.settings.fluid.surface != Surface::full && ledger.start_volume() > 0)
    row.add("settled_volume", "", liquid_volume(s, pool) / ledger.start_volume());
  if (s.settings.fluid.surface != Surface::full) add_reach(row, s.settings, s.grid, s.walls, s.particles);
  for (std::size_t i = 0; i < stage_names.size(); ++i)
    if (const auto stage = static_cast<Stage>(i); ledger.can_have(stage, s.settings))
      row.add("lost_" + std::string(stage_names[i].name), joule, -ledger.total(stage, Ledger::kinetic));
  if (noise) row.add("noise", "m/s", root_mean_square(noise_of(s, pool)));
  return row;
}

namespace {

/// Why the angular momentum need not hold in the steps of this run; empty where it must, but for walls.
template <int Dim, class Real> std::vector<std::string> about_spin(const FluidState<Dim, Real>& s) {
  const TransferSettings& transfer = s.settings.transfer;
  const Corner corner = transfer.corner();
  const bool linear = transfer.kernel == KernelName::linear;
  std::vector<std::string> list;
  if (corner.flip_ratio > 0 || corner.order > 1)
    list.emplace_back("Particles keep velocity that the grid does not have: G2P may change angular momentum and add "
                      "energy.");
  else if (corner.mode == AffineMode::none || corner.affine < 1)
    list.emplace_back("Particles do not keep all of the grid's rotation: G2P changes angular momentum.");
  else if (corner.skew && linear)
    list.emplace_back("With the linear kernel the skew part of C is not the spin: G2P changes angular momentum.");
  if (s.settings.time.advection != Advection::rk1)
    list.emplace_back("Particles move by rk2 or rk3, not by v_p: advection may change angular momentum.");
  else if (s.settings.time.splitting != Splitting::lie)
    list.emplace_back("Half steps move particles by another velocity than v_p: advection may change angular momentum.");
  else if (linear && corner.mode != AffineMode::none)
    list.emplace_back("With the linear kernel advection changes the angular momentum of the affine part.");
  return list;
}

} // namespace

template <int Dim, class Real> std::vector<std::string> notes(const FluidState<Dim, Real>& s) {
  std::vector<std::string> list;
  bool periodic = false, walls = false;
  for (int a = 0; a < Dim; ++a) (s.walls.periodic(a) ? periodic : walls) = true;
  if (periodic)
    list.emplace_back("With a periodic axis the angular momentum is not defined.");
  else
    list = about_spin(s);
  if (walls || !s.solids.none()) list.emplace_back("Walls take momentum; only the transfers are claimed to keep it.");
  if (s.settings.time.splitting != Splitting::lie)
    list.emplace_back("One of the two projections of a step reaches the particles as in FLIP, whatever the scheme.");
  if (s.solve.residual > std::max(s.settings.pressure.tolerance, 1e-5))
    list.emplace_back("The pressure solve ended above its tolerance.");
  return list;
}

std::vector<std::string> warnings(const SolveReport& solve) {
  if (solve.stalls == 0) return {};
  return {"multigrid stalled in " + std::to_string(solve.stalls) + " pressure solve" + (solve.stalls == 1 ? "" : "s") +
          ", which MIC(0) conjugate gradients finished"};
}

#define FLIPBOOK_HISTORY(Dim, Real)                                                                                    \
  template HistoryRow history_row(const FluidState<Dim, Real>&, FluidLedger<Dim, Real>&, bool, Pool&);                 \
  template std::vector<std::string> notes(const FluidState<Dim, Real>&);
FLIPBOOK_HISTORY(2, float)
FLIPBOOK_HISTORY(2, double)
FLIPBOOK_HISTORY(3, float)
FLIPBOOK_HISTORY(3, double)
#undef FLIPBOOK_HISTORY

} // namespace flipbook
