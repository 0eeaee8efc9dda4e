// SPDX-License-Identifier: MIT
// What a contact sheet (view.layout = "sheet") shows: parameters below `view.`.
#pragma once

#include "sim/frame/parameters.h"

#include <cstddef>
#include <string>

namespace flipbook::render {

struct SheetSettings {
  int columns = 0;                 ///< 0: about as many as rows
  std::string sparkline = "total"; ///< column of the ledger; empty: no curves

  /// Among the other parameters of the view.
  void describe(ParameterVisitor& v);
  /// Of so many panes.
  [[nodiscard]] std::size_t columns_of(std::size_t panes) const;
};

/// Panes of a picture: as a sheet, and otherwise.
inline constexpr std::size_t most_sheet_panes = 36, most_panes = 12;

} // namespace flipbook::render
