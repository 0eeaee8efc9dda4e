// SPDX-License-Identifier: MIT
// How the panes share a picture: all alike, one large, or two behind a divider; and a pane of what two of them differ
// in. The parameters are below `view.`.
#pragma once

#include "sim/frame/parameters.h"

#include <array>
#include <cstddef>

namespace flipbook::render {

enum class Placing { grid, large, split, sheet }; // the last: render/compose/sheet.h
enum class DifferenceOf { off, speed, density, surface };

struct Arrangement {
  Placing layout = Placing::grid;
  int large = 1;                 ///< pane, from 1; one more than there are panes: the difference
  std::array<int, 2> pair{1, 2}; ///< panes, from 1: left and right of the divider, A and B of the difference
  double divider = 0.5;          ///< share of the domain's width that is left of it
  DifferenceOf difference = DifferenceOf::off; ///< A minus B
  double difference_range = 0;                 ///< where its colours end; 0: found from the data

  /// Among the other parameters of the view.
  void describe(ParameterVisitor& v);
  /// Is the pair looked at?
  [[nodiscard]] bool pairs() const { return layout == Placing::split || difference != DifferenceOf::off; }
  /// Index of the pane on the left or right (0, 1) of the pair, from 0.
  [[nodiscard]] std::size_t pane(std::size_t side) const { return static_cast<std::size_t>(pair[side]) - 1; }
};

} // namespace flipbook::render
