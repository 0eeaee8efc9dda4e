// SPDX-License-Identifier: MIT
// What stands at the margins of a contact sheet: the parameters that differ from row to row, and those that differ from
// column to column, as the solvers that run have them.
#pragma once

#include "app/study/titles.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

struct MarginNames {
  std::vector<std::string> rows, columns;
};

/// Both empty where rows and columns do not tell the panes apart: where a parameter differs in both, where a pane has a
/// label of its own, or where two rows would be named alike.
[[nodiscard]] MarginNames margin_names(std::span<const TitledPane> panes, std::size_t columns);

} // namespace flipbook::app
