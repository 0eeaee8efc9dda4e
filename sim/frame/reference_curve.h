// SPDX-License-Identifier: MIT
// Values of others that a plot is compared with: an experiment's points, an exact or converged curve.
#pragma once

#include "sim/frame/errors.h"

#include <string>
#include <vector>

namespace flipbook {

struct ReferenceCurve {
  enum class Style { points, line };
  std::string plot;  ///< the name of the curve that it belongs to: "front"
  std::string label; ///< whose values they are: "Martin & Moyce 1952"
  Style style = Style::points;
  std::vector<double> t, y; ///< seconds simulated and the plot's unit; as many of each, t in rising order
  Location where;           ///< in the study or scene that names it
};

} // namespace flipbook
