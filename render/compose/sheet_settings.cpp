// SPDX-License-Identifier: MIT
#include "render/compose/sheet_settings.h"

#include <algorithm>
#include <cmath>

namespace flipbook::render {

void SheetSettings::describe(ParameterVisitor& v) {
  v.integer({.name = "sheet_columns",
             .help = "Columns of layout = \"sheet\", which has up to 36 panes; 0: about as many as rows.",
             .min = 0,
             .max = static_cast<double>(most_sheet_panes)},
            columns);
  v.text({.name = "sparkline",
          .help = "Curve below each pane of a sheet, by the name of the ledger's column; empty: none."},
         sparkline);
}

std::size_t SheetSettings::columns_of(std::size_t panes) const {
  if (columns > 0)
    return std::clamp<std::size_t>(static_cast<std::size_t>(columns), 1, std::max<std::size_t>(panes, 1));
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(std::max<std::size_t>(panes, 1)))));
}

} // namespace flipbook::render
