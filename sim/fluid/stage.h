// SPDX-License-Identifier: MIT
// The parts that a step of the fluid consists of, in their order: what the ledger keeps account of.
#pragma once

#include "sim/core/profile.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace flipbook {

enum class Stage {
  p2g,
  free_faces, ///< faces that got mass but touch no liquid are extrapolated over, for every scheme alike
  forces,
  walls,
  projection,
  extrapolation, ///< into the air; the constraint in obstacles
  second_half,   ///< splittings that act in the middle of a step double the change of the grid
  g2p,
  advection, ///< with pushing out of obstacles
  spacing
};

struct StageName {
  std::string_view name, label; ///< as in files, as in pictures
};
inline constexpr std::array<StageName, 10> stage_names{{{"p2g", "P2G"},
                                                        {"free_faces", "free faces"},
                                                        {"forces", "forces"},
                                                        {"walls", "walls"},
                                                        {"projection", "projection"},
                                                        {"extrapolation", "extrapolation"},
                                                        {"second_half", "second half"},
                                                        {"g2p", "G2P"},
                                                        {"advection", "advection"},
                                                        {"spacing", "spacing"}}};

/// What a stage is to the profile.
[[nodiscard]] constexpr Phase phase_of(Stage stage) {
  switch (stage) {
  case Stage::p2g: return Phase::p2g;
  case Stage::free_faces:
  case Stage::extrapolation: return Phase::extrapolate;
  case Stage::forces:
  case Stage::walls:
  case Stage::second_half: return Phase::forces;
  case Stage::projection: return Phase::pressure_solve; // which tells its set-up apart
  case Stage::g2p: return Phase::g2p;
  case Stage::advection:
  case Stage::spacing: break;
  }
  return Phase::advect;
}

} // namespace flipbook
