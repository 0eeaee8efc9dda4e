// SPDX-License-Identifier: MIT
// What round trips publish: a snapshot for each frame, with the curves of all frames so far.
#pragma once

#include "sim/frame/curves.h"
#include "sim/frame/snapshot.h"
#include "sim/transfer_only/trip_ledger.h"

namespace flipbook {

template <int Dim, class Real> class TripRecorder {
public:
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(const TripState<Dim, Real>& state,
                                                         TripLedger<Dim, Real>& ledger, std::uint64_t frame,
                                                         const FrameRequest& request, Pool& pool);

private:
  [[nodiscard]] Channel channel(const TripState<Dim, Real>& state, const std::string& name, Pool& pool);
  [[nodiscard]] HistoryRow row(const TripState<Dim, Real>& state, const TripLedger<Dim, Real>& ledger, bool with_noise,
                               Pool& pool) const;

  ChannelRanges ranges_;
  History history_;
};

} // namespace flipbook
