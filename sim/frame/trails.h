// SPDX-License-Identifier: MIT
// Where some of the particles of a 2D run have been, for the lines behind them. Which ones follows from their ids
// alone, so that all panes show the ways of the same particles.
#pragma once

#include "sim/frame/snapshot.h"

namespace flipbook {

class Trails {
public:
  static constexpr std::size_t most_ways = 200; ///< about so many particles
  static constexpr std::size_t most_rows = 160; ///< points of each

  /// Remembers where they are in this snapshot, whose time has not been before, and gives it the points of the last
  /// `seconds`.
  void follow(Snapshot& s, double seconds);

private:
  [[nodiscard]] bool chosen(std::uint32_t id) const;
  [[nodiscard]] std::shared_ptr<const TrailPoints> points(const Snapshot& s);

  std::vector<std::shared_ptr<const TrailPoints>> rows_;
  double share_ = 0; ///< of all particles; 0: not yet known
};

} // namespace flipbook
