// SPDX-License-Identifier: MIT
// A report as text: the table that is printed, and what spreadsheets read.
#pragma once

#include "app/validate/case.h"

namespace flipbook::app {

/// The case, what was run, and a line for each row; rows that failed say so.
[[nodiscard]] std::string table_text(const ValidationCase& c, const ValidationReport& report);

/// case,scheme,setting,cells,cfl,quantity,unit,seeds,mean,min,max,reference,gate_lo,gate_hi,passed; 17 digits.
[[nodiscard]] std::string csv_text(const ValidationCase& c, const ValidationReport& report);

/// The points of the figure: panel,series,x,y,lo,hi.
[[nodiscard]] std::string curves_text(const ValidationReport& report);

} // namespace flipbook::app
