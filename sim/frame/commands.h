// SPDX-License-Identifier: MIT
// The one log of edits. The timeline, the panel, a browser and replay all change a run through it and in no other way;
// a command takes effect at a frame boundary, before the steps that lead to the next frame.
#pragma once

#include "sim/frame/interactions.h"
#include "sim/frame/parameters.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace flipbook {

/// Gives a parameter a value.
struct SetParameter {
  std::string path;
  Value value;
};

using CommandAction = std::variant<SetParameter, Interaction>;

struct Command {
  std::uint64_t frame = 0; ///< applied when the run stands at this frame
  int variant = -1;        ///< which pane; -1: every pane (that has the parameter)
  CommandAction action;
};

using CommandLog = std::vector<Command>; ///< sorted by frame; commands of one frame in order

} // namespace flipbook
