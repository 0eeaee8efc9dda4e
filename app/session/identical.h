// SPDX-License-Identifier: MIT
// Two panes whose particles agree to the last bit compare a scheme with itself. Only after several steps, though: the
// first from rest is the same for all schemes; and not where nothing flows.
#pragma once

#include "sim/frame/snapshot.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

class IdenticalPanes {
public:
  /// One line for each group of identical panes: "panes 1, 2 and 4 show identical particles". Wants the pictures of a
  /// run in their order.
  [[nodiscard]] std::vector<std::string> warnings(std::span<const std::shared_ptr<const Snapshot>> panes);

  static constexpr std::uint64_t enough_steps = 5; ///< since the particles began to move

private:
  struct Past {
    bool moves = false;
    std::uint64_t last = 0; ///< steps at the picture before; before the first movement once there was one
  };
  std::vector<Past> past_;
};

} // namespace flipbook::app
