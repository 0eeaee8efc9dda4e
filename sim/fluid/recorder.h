// SPDX-License-Identifier: MIT
// What a run publishes: a snapshot for each frame, with the extremes and the curves of all frames so far.
#pragma once

#include "sim/fluid/fluid_ledger.h"
#include "sim/fluid/solid_surfaces.h"
#include "sim/frame/curves.h"
#include "sim/frame/snapshot.h"
#include "sim/frame/trails.h"

#include <string>

namespace flipbook {

template <int Dim, class Real> class Recorder {
public:
  /// Remembers where each particle starts, by id: ids must be smaller than a few times their number.
  explicit Recorder(const Particles<Dim, Real>& seeded);

  /// Remembers where particles start that have come in since.
  void follow(const Particles<Dim, Real>& particles);
  /// An id that no particle ever had.
  [[nodiscard]] std::uint32_t next_id() const { return static_cast<std::uint32_t>(initial_.size()); }

  /// Without a ledger there are no curves either.
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(const FluidState<Dim, Real>& state,
                                                         FluidLedger<Dim, Real>* ledger, std::uint64_t frame,
                                                         const FrameRequest& request, Pool& pool);

private:
  [[nodiscard]] Channel channel(const FluidState<Dim, Real>& state, const std::string& name, Pool& pool);

  std::vector<std::array<float, 3>> initial_;
  ChannelRanges ranges_;
  History history_;
  Trails trails_;
  SolidSurfaces surfaces_;
};

} // namespace flipbook
