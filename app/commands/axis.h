// SPDX-License-Identifier: MIT
// What the rows or the columns of a filmstrip or a contact sheet are: times, schemes, or values of any parameter.
#pragma once

#include "app/commands/variants.h"
#include "app/study/study.h"

#include <string>
#include <vector>

namespace flipbook::app {

struct Axis {
  std::vector<double> times;       ///< empty: it is not about times
  std::vector<Changes> changes;    ///< what each entry changes of the study
  std::vector<std::string> labels; ///< of the entries

  [[nodiscard]] bool empty() const { return labels.empty(); }
};

/// `t=0.2,0.4`, `schemes=pic,flip:0.97` or `path=value,value`; nothing for an empty text. Throws UserError.
[[nodiscard]] Axis parse_axis(const std::string& text, const std::string& option, const Study& study);

/// What the panes change, row by row; a single pane without changes where no axis has any. Throws UserError where an
/// option gives all of them a value of what they are to differ in.
[[nodiscard]] std::vector<Changes> panes_of(const Study& study, const Axis& rows, const Axis& columns);

} // namespace flipbook::app
