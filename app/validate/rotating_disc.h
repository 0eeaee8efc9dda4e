// SPDX-License-Identifier: MIT
// Runs of the turning elastic disc, for the validation case and for figures.
#pragma once

#include "app/validate/experiment.h"

#include <functional>

namespace flipbook::app {

inline constexpr int disc_frames = 32;                                           ///< of a revolution
inline constexpr double disc_rotation = 2, disc_centre = 0.5, disc_radius = 0.3; ///< rad/s; m

/// What the particles hold at the frames 0 .. frames, over that of the start.
struct DiscTurn {
  std::vector<double> L, E; ///< angular momentum; kinetic and elastic energy
  [[nodiscard]] double largest_change() const {
    double most = 0;
    for (const double l : L) most = std::max(most, std::abs(l - 1));
    return most;
  }
};

[[nodiscard]] std::unique_ptr<Simulation> start_disc(const Setup& setup, int seed, Pool& pool);

/// Sees every frame.
using DiscLook = std::function<void(int frame, const std::shared_ptr<const Snapshot>&)>;

/// Lets it turn.
[[nodiscard]] DiscTurn turn_disc(Simulation& sim, int cells, int revolutions, const DiscLook& look = {},
                                 const FrameRequest& request = {});

} // namespace flipbook::app
