// SPDX-License-Identifier: MIT
// The [[edit]] tables of a study: what a hand did in a live session, in order. Each acts at the first frame boundary
// that is not before its time, after the picture of that frame.
//
//   [[edit]]
//   t = 1.5
//   pane = 2                      # from 1; all panes if it is left out
//   transfer.flip_ratio = 0.5     # or one of:
//   push = { at = [0.3, 0.2], radius = 0.1, velocity = [1, 0] }
//   add = { at = [0.3, 0.2], radius = 0.1 }
//   remove = { at = [0.3, 0.2], radius = 0.1 }
//   move = { solid = 1, by = [0.1, 0], over = 0.5 }
#pragma once

#include "sim/frame/commands.h"
#include "sim/scene/toml_reader.h"

#include <string>
#include <vector>

namespace flipbook::app {

using flipbook::to_toml; // joined by the one for edits below

struct Edit {
  double t = 0;
  int pane = 0; ///< from 1; 0: all
  CommandAction action;
  Location where{};
};

/// What a table says; mistakes are collected.
void read_edit(const Node& node, std::vector<Edit>& edits, Mistakes& mistakes);
/// The same as text, with its heading.
[[nodiscard]] std::string to_toml(const Edit& edit);

} // namespace flipbook::app
