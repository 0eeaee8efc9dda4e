// SPDX-License-Identifier: MIT
// What a run publishes: a snapshot for each frame, with the extremes and the curves of all frames so far.
#pragma once

#include "sim/fluid/fluid_state.h"
#include "sim/frame/snapshot.h"

#include <map>
#include <string>

namespace flipbook {

template <int Dim, class Real> class Recorder {
public:
  /// Remembers where each particle starts, by id: ids must be smaller than a few times their number.
  explicit Recorder(const Particles<Dim, Real>& seeded);

  /// `transfer_loss`: kinetic energy that the transfers have lost so far.
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(const FluidState<Dim, Real>& state, double transfer_loss,
                                                         std::uint64_t frame, const FrameRequest& request, Pool& pool);

private:
  [[nodiscard]] Channel channel(const FluidState<Dim, Real>& state, const std::string& name, Pool& pool);
  void extend_history(const FluidState<Dim, Real>& state, double transfer_loss, Pool& pool);

  std::vector<std::array<float, 3>> initial_;
  std::map<std::string, std::pair<double, double>, std::less<>> extremes_; ///< of each channel
  History history_;
};

} // namespace flipbook
