// SPDX-License-Identifier: MIT
// The ledger of each pane as a table beside or below it, with the pane's notes. How much of it is shown depends on the
// room: the layout chooses among the forms by what each leaves of the panes.
#pragma once

#include "render/frame.h"
#include "render/gui/ink.h"
#include "render/theme.h"
#include "render/views/ledger_text.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

/// One way to show the tables of all panes, which have the same size.
struct LedgerForm {
  gui::Type type = gui::Type::body;
  LedgerColumns columns = LedgerColumns::all;
  bool before = true;          ///< with the row of what was held before
  float width = 0, height = 0; ///< pixels that a table needs
  float worth = 1;             ///< of what it shows; 1: everything
};

/// From the fullest to the briefest; empty where view.ledger is off or no pane has a ledger. The sizes depend on the
/// stages, quantities and notes, not on values: tables stay where they are from frame to frame. `notes` holds those to
/// be said below the table of each pane; no entries: none.
[[nodiscard]] std::vector<LedgerForm> ledger_forms(const Frame& frame, LedgerView view, const gui::Fonts& fonts,
                                                   std::span<const std::vector<std::string>> notes);

/// Draws the table of a snapshot into its box; the notes take what is left of it.
void draw_ledger(gui::Ink& ink, const Rect& box, const Snapshot& s, LedgerView view, const LedgerForm& form,
                 std::span<const std::string> notes, const Palette& palette);

} // namespace flipbook::render
