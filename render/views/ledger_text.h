// SPDX-License-Identifier: MIT
// What the table of a ledger says, in words and numbers: a row for each stage of a step, between what the particles
// held before and what they hold now, and a sentence about where kinetic energy was lost. Changes of kinetic energy are
// in percent of the energy that there was to spend (LedgerTable::energy_in, or step_in for the last step).
#pragma once

#include "render/view_settings.h"
#include "sim/frame/snapshot.h"

#include <string>
#include <string_view>
#include <vector>

namespace flipbook::render {

/// Which columns there are, from the most to the fewest: kinetic energy always, then angular momentum, linear momentum
/// (2D: its components, else its length), potential energy.
enum class LedgerColumns { all, without_potential, lengths, no_momentum, energy };
inline constexpr int ledger_column_sets = 5;

struct LedgerCell {
  std::string text;
  LedgerTable::Claim claim = LedgerTable::Claim::none;
  bool nothing = false; ///< zero but for rounding: a dot
};

struct LedgerColumn {
  std::string symbol, index;     ///< "p", "x"
  std::string unit;              ///< of kinetic energy: "% of 2.35 kJ/m"
  std::vector<LedgerCell> cells; ///< one for each row
};

struct LedgerText {
  std::string title;             ///< "since the start"
  std::vector<std::string> rows; ///< "before", the stages, "now"
  std::vector<LedgerColumn> columns;
  std::string sentence; ///< "Kinetic energy lost: G2P 3.1 %, projection 0.4 %, elsewhere 0."
};

/// `s` has a ledger, `view` is not off.
[[nodiscard]] LedgerText ledger_text(const Snapshot& s, LedgerView view, LedgerColumns columns);

/// The widest text that a cell can hold.
inline constexpr std::string_view widest_cell = "−0000.0";

} // namespace flipbook::render
