// SPDX-License-Identifier: MIT
// A command of the log reaches its simulations: the same function for a script, a replay and a hand.
#pragma once

#include "app/session/stepper.h"
#include "sim/frame/commands.h"

namespace flipbook::app {

/// The panes (from 0) that a command is for: the one that it names, or all that have a use for it.
[[nodiscard]] std::vector<int> panes_of(const Command& command, Stepper& variants);

/// Between steps. Message empty: done. One that no pane has a use for is refused. The view is none of theirs: see
/// EditedView.
[[nodiscard]] Refusal apply_command(const Command& command, Stepper& variants);

/// The same where a refusal ends the run: throws UserError, which begins with `who` asks.
void must_apply(const Command& command, Stepper& variants, const char* who);

} // namespace flipbook::app
