// SPDX-License-Identifier: MIT
// What the rows and columns of a filmstrip are: times, schemes, or values of any parameter.
#pragma once

#include "app/commands/variants.h"
#include "app/study/study.h"

#include <string>
#include <vector>

namespace flipbook::app {

struct StripAxis {
  std::vector<double> times;       ///< empty: it is not about times
  std::vector<Changes> changes;    ///< what each entry changes of the study
  std::vector<std::string> labels; ///< of the entries

  [[nodiscard]] bool empty() const { return labels.empty(); }
};

/// `t=0.2,0.4`, `schemes=pic,flip:0.97` or `path=value,value`; nothing for an empty text. Throws UserError.
[[nodiscard]] StripAxis parse_strip_axis(const std::string& text, const std::string& option, const Study& study);

struct StripRequest {
  std::string rows, columns;
  std::vector<double> at; ///< the time where neither is about times
  double width = 174;     ///< mm
};

} // namespace flipbook::app
