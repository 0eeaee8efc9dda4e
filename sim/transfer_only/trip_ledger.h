// SPDX-License-Identifier: MIT
// The ledger of round trips: what the particles hold and what P2G and G2P changed of it. The grid's share of a trip
// lies between the two: P2G's change is what the grid holds less what the particles held, G2P's the way back.
#pragma once

#include "sim/diagnostics/account.h"
#include "sim/diagnostics/ledger.h"
#include "sim/transfer_only/trip_state.h"

#include <cstddef>

namespace flipbook {

template <int Dim, class Real> class TripLedger {
public:
  /// Off where ledger.on is false: it then measures nothing.
  TripLedger(const TripState<Dim, Real>& start, Pool& pool);

  void after_p2g(const TripState<Dim, Real>& state, Pool& pool);
  /// With state.steps and state.time at the end of the trip.
  void after_g2p(const TripState<Dim, Real>& state, Pool& pool);

  [[nodiscard]] bool on() const { return on_; }
  /// Held by the particles at the start and after the last trip; what both transfers took since the start.
  [[nodiscard]] double start(std::size_t quantity) const { return start_[quantity]; }
  [[nodiscard]] double held(std::size_t quantity) const { return account_.held()[quantity]; }
  enum Stage : std::size_t { p2g, g2p };
  [[nodiscard]] double change(Stage stage, std::size_t quantity) const { return account_.total(stage, quantity); }
  /// What the quantities are: names, units, whether they are defined.
  [[nodiscard]] const std::vector<LedgerTable::Quantity>& quantities() const { return quantities_; }
  /// The table with the accounts since the last call.
  [[nodiscard]] LedgerTable publish() { return account_.publish({true, true}); }

  /// Where a quantity stands in the table; in 3D there are three angular momenta.
  static constexpr std::size_t mass = 0, momentum = 1, angular_momentum = 1 + Dim,
                               kinetic = 1 + Dim + static_cast<std::size_t>(spin<Dim>);

private:
  [[nodiscard]] Account::Numbers on_particles(const TripState<Dim, Real>& state, Pool& pool) const;
  /// What the propositions say about this stage, against what it did in this trip.
  void judge(Stage stage, const Corner& corner, KernelName kernel);

  bool on_;
  Vec<Dim, double> origin_;
  std::vector<LedgerTable::Quantity> quantities_;
  Account account_;
  Account::Numbers start_;
  Account::Numbers scale_; ///< of each quantity: what rounding is measured against
};

} // namespace flipbook
