// SPDX-License-Identifier: MIT
// What a filmstrip is to show.
#pragma once

#include <string>
#include <vector>

namespace flipbook::app {

struct StripRequest {
  std::string rows, columns; ///< see axis.h
  std::vector<double> at;    ///< the time where neither is about times
  double width = 174;        ///< mm
};

} // namespace flipbook::app
