// SPDX-License-Identifier: MIT
// The parts that a step of the material point method consists of, in their order: what the ledger keeps account of.
#pragma once

#include "sim/core/profile.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace flipbook {

enum class MpmStage {
  p2g,
  forces,  ///< gravity
  stress,  ///< forces of the material on the grid
  contact, ///< walls and obstacles
  g2p,
  motion, ///< particles move and deform; with pushing out of obstacles
  flow    ///< plastic flow
};

struct MpmStageName {
  std::string_view name, label; ///< as in files, as in pictures
};
inline constexpr std::array<MpmStageName, 7> mpm_stage_names{{{"p2g", "P2G"},
                                                              {"forces", "forces"},
                                                              {"stress", "stress"},
                                                              {"contact", "contact"},
                                                              {"g2p", "G2P"},
                                                              {"motion", "motion"},
                                                              {"flow", "plastic flow"}}};

} // namespace flipbook
