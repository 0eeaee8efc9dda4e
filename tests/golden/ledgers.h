// SPDX-License-Identifier: MIT
// Ledgers made by hand, in every state that a table can show.
#pragma once

#include "render/frame.h"

#include <string>
#include <vector>

namespace flipbook::test {

/// Quantities of the dimension and eight stages, nothing held and nothing changed yet.
[[nodiscard]] LedgerTable empty_ledger(int dim);

/// What a stage changed, since the start and in the last step alike; `quantity` may be the beginning of several names.
void set_change(LedgerTable& l, const std::string& stage, const std::string& quantity, double change);
void set_claim(LedgerTable& l, const std::string& stage, const std::string& quantity, LedgerTable::Claim claim);
/// "now" from "start" and the changes.
void close(LedgerTable& l);

/// A dam break: falls, hits a wall; momentum and L hold in both transfers (`affine`), or L fails in G2P.
[[nodiscard]] LedgerTable dam_ledger(int dim, bool affine);
/// FLIP: P2G takes what G2P gives back; L is not defined.
[[nodiscard]] LedgerTable vortex_ledger();

/// dam_frame() with ledgers, and notes of which one is shared by all panes.
[[nodiscard]] render::Frame ledger_frame(std::size_t panes);

} // namespace flipbook::test
