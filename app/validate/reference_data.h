// SPDX-License-Identifier: MIT
// Measured data of others, from the assets: two columns of numbers, with the source and the licence in comment lines.
#pragma once

#include <string>
#include <vector>

namespace flipbook::app {

struct ReferenceData {
  std::vector<double> x, y;
};

/// The table reference/NAME.csv. Throws MachineError where it is missing, UserError with the line where it is damaged.
[[nodiscard]] ReferenceData reference_data(const std::string& name);

} // namespace flipbook::app
